// Which view is where: both images in a column left of the cloud, or one of them in the place of the cloud.
#pragma once

#include <QObject>
#include <QStringList>

#include <array>

class QSplitter;

namespace edgescan::ui {

class Pane;

/// What most of the room is for. Images: one of them is in the place of the cloud.
enum class Share { Balanced, Images, Cloud };
inline const QStringList kShareNames{"balanced", "images", "cloud"};
[[nodiscard]] constexpr Share next(Share share) { return static_cast<Share>((static_cast<int>(share) + 1) % 3); }

/// GUI thread only.
class PanePlaces : public QObject {
    Q_OBJECT
public:
    /// `outer` holds the place of the images, then the place of the cloud; `images` the two places of images. Panes: range image, edge map,
    /// cloud.
    PanePlaces(QSplitter& outer, QSplitter& images, const std::array<Pane*, 3>& panes, QObject* parent);

    void setShare(Share share);
    [[nodiscard]] Share share() const { return share_; }
    /// The pane and the cloud change places. Of a pane that did, or of the cloud: back.
    void swap(Pane* pane);
    /// The pane in the place of the cloud.
    [[nodiscard]] Pane* inCloudsPlace() const { return swapped_ != nullptr ? swapped_ : panes_.back(); }
    /// The share, and the name of the view in the place of the cloud, to be stored; and back.
    [[nodiscard]] QString text() const;
    void use(const QString& text);

signals:
    void changed();
    void shareChanged(edgescan::ui::Share share);

private:
    void place();

    QSplitter& outer_;
    QSplitter& images_;
    std::array<Pane*, 3> panes_;
    Pane* swapped_ = nullptr; // it is in the place of the cloud; null: none
    Share share_ = Share::Balanced;
};

} // namespace edgescan::ui
