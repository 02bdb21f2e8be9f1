// An image in a corner of the cloud. A tap exchanges image and cloud.
#pragma once

#include <QAbstractButton>
#include <QImage>
#include <QPixmap>
#include <QPoint>

#include <memory>
#include <optional>

namespace edgescan::ui {

/// GUI thread only. In the upper right corner of its parent.
class CornerPicture : public QAbstractButton {
    Q_OBJECT
public:
    explicit CornerPicture(QWidget* parent);

    /// One pixel per cell; `marked`: x = beam, y = line. Null image: only the text.
    void show(std::shared_ptr<const QImage> image, std::optional<QPoint> marked);
    void setWords(const QString& words);
    [[nodiscard]] const std::shared_ptr<const QImage>& image() const { return image_; }

    /// Distance of its left edge from the right edge of its parent, px.
    [[nodiscard]] int reach() const;

    bool eventFilter(QObject* watched, QEvent* event) override;

signals:
    void reachChanged(int px);

protected:
    void changeEvent(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    void place();
    [[nodiscard]] int wordsHeight(int width) const;

    std::shared_ptr<const QImage> image_;
    std::optional<QPoint> marked_;
    QPixmap scaled_;
    int words_ = 0; // px of its height
};

} // namespace edgescan::ui
