// Draws labels, and the grey overlay of a stale picture.
#include "ui/base/marks.h"

#include <algorithm>

namespace edgescan::ui {

QRect drawLabel(QPainter& painter, const QRect& place, Qt::Alignment alignment, const QString& text) {
    if (text.isEmpty()) return {};
    const QRect box = painter.boundingRect(place, static_cast<int>(alignment) | Qt::TextWordWrap, text).adjusted(-6, -3, 6, 3);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(0, 0, 0, 150));
    painter.drawRoundedRect(box, 3, 3);
    painter.setPen(QColor(235, 235, 235));
    painter.drawText(box, static_cast<int>(Qt::AlignCenter) | Qt::TextWordWrap, text);
    return box;
}

QRect tipBox(const QFontMetrics& metrics, const QRect& place, const QPoint& at, const QString& text) {
    constexpr int kOffset = 14; // px
    QRect box = metrics.boundingRect(QRect(0, 0, place.width() - 12, place.height()), Qt::TextWordWrap, text).adjusted(-6, -3, 6, 3);
    box.moveTopLeft(at + QPoint(kOffset, kOffset));
    if (box.bottom() > place.bottom()) box.moveBottom(at.y() - kOffset);
    box.moveLeft(std::max(place.left(), std::min(box.left(), place.right() - box.width())));
    return box;
}

void drawTipAt(QPainter& painter, const QRect& place, const QPoint& at, const QString& text) {
    const QRect box = tipBox(painter.fontMetrics(), place, at, text);
    painter.setPen(Qt::black);
    painter.setBrush(QColor(255, 255, 255, 235));
    painter.drawRect(box);
    painter.drawText(box, static_cast<int>(Qt::AlignCenter) | Qt::TextWordWrap, text);
}

namespace {

QRect drawPlate(QPainter& painter, const QRect& place, const PictureFrame& frame) {
    constexpr int kFlags = static_cast<int>(Qt::AlignHCenter | Qt::AlignTop) | Qt::TextWordWrap;
    const QFont usual = painter.font();
    QFont large = usual;
    large.setBold(true);
    large.setPointSizeF(large.pointSizeF() * 2.0);
    painter.setFont(large);
    QRect words = painter.boundingRect(place, kFlags, frame.words);
    painter.setFont(usual);
    QRect more = frame.more.isEmpty() ? QRect() : painter.boundingRect(place, kFlags, frame.more);
    words.moveTop(place.center().y() - (words.height() + more.height()) / 2);
    more.moveTop(words.bottom() + 1);
    painter.setPen(QPen(frame.colour, 2.0));
    painter.setBrush(QColor(27, 29, 31));
    const QRect plate = (more.isEmpty() ? words : words.united(more)).adjusted(-12, -6, 12, 6);
    painter.drawRect(plate);
    painter.setPen(Qt::white);
    painter.drawText(more, kFlags, frame.more);
    painter.setFont(large);
    painter.drawText(words, kFlags, frame.words);
    return plate;
}

} // namespace

QRect drawPictureFrame(QPainter& painter, const QRect& place, const PictureFrame& frame) {
    if (!frame.colour.isValid()) return {};
    constexpr int kBorder = 4, kHatch = 32; // px
    painter.save();
    painter.setClipRect(place);
    painter.setBrush(Qt::NoBrush);
    if (!frame.words.isEmpty()) {
        QColor thin = frame.colour;
        thin.setAlpha(160);
        painter.setPen(QPen(thin, 3.0));
        for (int x = place.left() - place.height(); x < place.right(); x += kHatch)
            painter.drawLine(x, place.bottom(), x + place.height(), place.top());
    }
    painter.setPen(QPen(frame.colour, kBorder, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
    painter.drawRect(place.adjusted(kBorder / 2, kBorder / 2, -kBorder / 2, -kBorder / 2));
    const QRect plate = frame.words.isEmpty() ? QRect() : drawPlate(painter, place, frame);
    painter.restore();
    return plate;
}

} // namespace edgescan::ui
