// An image in a corner of the cloud; a tap swaps the two.
#pragma once

#include <QAbstractButton>
#include <QImage>
#include <QPixmap>
#include <QPoint>

#include <memory>
#include <optional>

namespace edgescan::ui {

/// GUI thread only. Stands in the upper right corner of its parent.
class CornerPicture : public QAbstractButton {
    Q_OBJECT
public:
    explicit CornerPicture(QWidget* parent);

    /// One pixel per cell; `marked`: x = beam, y = line. Null image: only the words.
    void show(std::shared_ptr<const QImage> image, std::optional<QPoint> marked);
    void setWords(const QString& words);

    /// How far it reaches from the right side of its parent, px.
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
};

} // namespace edgescan::ui
