// Marks over the pictures: lines that are visible on black and on white, labels, and a grey overlay for a stale picture.
#pragma once

#include <QPainter>
#include <QString>

namespace edgescan::ui {

/// Draws twice: dark and wide, then light and thin.
template <class Draw>
void strokeTwice(QPainter& painter, const QPen& dark, const QPen& light, Draw draw) {
    painter.setPen(dark);
    draw();
    painter.setPen(light);
    draw();
}

/// A short text on a dark background, aligned in `place`. Returns the box that it covers; null if `text` is empty.
QRect drawLabel(QPainter& painter, const QRect& place, Qt::Alignment alignment, const QString& text);

/// A short text on a white background next to a point, completely inside `place`.
void drawTipAt(QPainter& painter, const QRect& place, const QPoint& at, const QString& text);
/// The box that drawTipAt() covers.
[[nodiscard]] QRect tipBox(const QFontMetrics& metrics, const QRect& place, const QPoint& at, const QString& text);

/// A border of 4 px in the colour of the source's badge, round a picture that does not follow the scanner.
struct PictureFrame {
    QColor colour{}; ///< invalid: no frame
    QString words{}; ///< "STALE 3 s": in large letters, on a hatch over the whole picture; empty: only the border
    QString more{};  ///< below them in usual letters
    bool operator==(const PictureFrame&) const = default;
};
/// Returns the box with the words; null if there are none. It avoids what is over the right side of the place.
QRect drawPictureFrame(QPainter& painter, const QRect& place, const PictureFrame& frame, const QRect& avoided = {});

} // namespace edgescan::ui
