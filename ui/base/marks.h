// What is drawn over the pictures: lines that are seen on black and on white, labels, and gray over a picture that is older than it seems.
#pragma once

#include <QPainter>
#include <QString>

namespace edgescan::ui {

/// Dark and wide, then light and thin.
template <class Draw>
void strokeTwice(QPainter& painter, const QPen& dark, const QPen& light, Draw draw) {
    painter.setPen(dark);
    draw();
    painter.setPen(light);
    draw();
}

/// A short text on a dark ground, somewhere in `place`.
void drawLabel(QPainter& painter, const QRect& place, Qt::Alignment alignment, const QString& text);

/// A short text on a white ground beside a point, so that all of it lies in `place`.
void drawTipAt(QPainter& painter, const QRect& place, const QPoint& at, const QString& text);
/// The ground that drawTipAt() covers.
[[nodiscard]] QRect tipBox(const QFontMetrics& metrics, const QRect& place, const QPoint& at, const QString& text);

/// Gray over `place`, and why in large letters. Nothing where `why` is empty.
void drawStaleOverlay(QPainter& painter, const QRect& place, const QString& why);

} // namespace edgescan::ui
