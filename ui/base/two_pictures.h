// Two pictures of the same place, one above the other, at one screen pixel per image pixel. Scrolling one scrolls the other.
#pragma once

#include <QImage>
#include <QString>
#include <QWidget>

#include <array>

class QLabel;
class QScrollArea;

namespace edgescan::ui {

class TwoPictures : public QWidget {
    Q_OBJECT
public:
    explicit TwoPictures(QWidget* parent = nullptr);

    /// `aboveWords`, `belowWords`: titles of the pictures. `busiest`: the pixel that is scrolled to the middle.
    void showPair(const QString& aboveWords, const QImage& above, const QString& belowWords, const QImage& below, QPoint busiest);
    void clear();
    [[nodiscard]] QImage picture(int place) const; ///< 0 above, 1 below; null before the first
    [[nodiscard]] QScrollArea* area(int place) const { return areas_[static_cast<std::size_t>(place)]; }

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void centre();

    std::array<QLabel*, 2> words_{}, pictures_{};
    std::array<QScrollArea*, 2> areas_{};
    QPoint busiest_;
    bool moved_ = false; // scrolled by the operator: a resize does not scroll it again
};

} // namespace edgescan::ui
