// Two pictures of the same place over each other, each pixel as it is; what one is scrolled by moves the other.
#pragma once

#include <QImage>
#include <QString>
#include <QWidget>

#include <array>

class QLabel;
class QScrollArea;

namespace edgescan::ui {

class LinkedPictures : public QWidget {
    Q_OBJECT
public:
    explicit LinkedPictures(QWidget* parent = nullptr);

    /// `above` and `below`: what is written over them. `busiest`: the pixel that comes into the middle.
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
    bool moved_ = false; // by hand: no resize moves it again
};

} // namespace edgescan::ui
