// An image in a corner of the cloud. A tap exchanges image and cloud.
#pragma once

#include <QAbstractButton>
#include <QImage>
#include <QPixmap>
#include <QPoint>
#include <QRegion>
#include <QTransform>
#include <QVector>

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace edgescan::ui {

/// What is chosen, in cells of the image: x = beam, y = line.
struct PictureMark {
    QVector<QPoint> cells;
    std::vector<std::pair<std::size_t, std::size_t>> links; ///< pairs of indices into `cells`; a line joins each pair
};

/// GUI thread only. In the upper right corner of its parent.
class CornerPicture : public QAbstractButton {
    Q_OBJECT
public:
    explicit CornerPicture(QWidget* parent);

    /// One pixel per cell. Null image: only the text.
    /// `toScreen`: how the image is turned (ViewPort::toScreen()).
    void show(std::shared_ptr<const QImage> image, const PictureMark& marked, const QTransform& toScreen = {});
    [[nodiscard]] const PictureMark& marked() const { return marked_; }
    void setWords(const QString& words);
    /// Its bottom is at this y in its parent, if that leaves it in the parent; at first it is at the top.
    void endAt(int bottom);
    [[nodiscard]] const std::shared_ptr<const QImage>& image() const { return image_; }

    /// Distance of its left edge from the right edge of its parent, px.
    [[nodiscard]] int reach() const;

    bool eventFilter(QObject* watched, QEvent* event) override;

signals:
    void reachChanged(int px);
    /// It became smaller or was hidden: this part of the screen was below it, and a finger may be on its way there.
    void uncovered(const QRegion& part);

protected:
    void changeEvent(QEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    void place();
    [[nodiscard]] int wordsHeight(int width) const;
    void drawLine(QPainter& painter, const QRect& line) const;

    std::shared_ptr<const QImage> image_;
    PictureMark marked_;
    QTransform toScreen_;
    QPixmap scaled_;
    int words_ = 0;  // px of its height
    int bottom_ = 0; // y in its parent
};

} // namespace edgescan::ui
