// Which view is where: both images in a column left of the cloud, or as large as they can be; and which of them has changed places with the
// cloud.
#pragma once

#include <QObject>

#include <array>

class QSplitter;

namespace edgescan::ui {

class Pane;

/// GUI thread only.
class PanePlaces : public QObject {
    Q_OBJECT
public:
    /// `outer` holds the place of the images, then the place of the cloud; `images` the two places of images. Panes: range image, edge map,
    /// cloud.
    PanePlaces(QSplitter& outer, QSplitter& images, const std::array<Pane*, 3>& panes, QObject* parent);

    void setImagesFirst(bool on);
    [[nodiscard]] bool imagesFirst() const { return imagesFirst_; }
    /// While the images are first; else one is above the other.
    void setSideBySide(bool on);
    /// The pane and the cloud change places. Of a pane that did, or of the cloud: back.
    void swap(Pane* pane);
    /// The pane in the place of the cloud.
    [[nodiscard]] Pane* inCloudsPlace() const { return swapped_ != nullptr ? swapped_ : panes_.back(); }
    /// The name of the view in the place of the cloud, to be stored; and back.
    [[nodiscard]] QString text() const;
    void use(const QString& text);
    /// After a splitter got back a stored state, which has an orientation of its own.
    void orient();

signals:
    void changed();
    void imagesFirstChanged(bool on);

private:
    void place();

    QSplitter& outer_;
    QSplitter& images_;
    std::array<Pane*, 3> panes_;
    Pane* swapped_ = nullptr; // it is in the place of the cloud; null: none
    bool imagesFirst_ = false, sideBySide_ = true;
};

} // namespace edgescan::ui
