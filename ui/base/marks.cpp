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

struct Plate {
    QRect words, more, box;
};

constexpr int kPlateFlags = static_cast<int>(Qt::AlignHCenter | Qt::AlignTop) | Qt::TextWordWrap;

Plate plateIn(QPainter& painter, const QRect& place, const PictureFrame& frame, const QFont& large) {
    constexpr int kAround = 12, kAbove = 6; // px
    const QFont usual = painter.font();
    const QRect room = place.adjusted(kAround, 0, -kAround, 0);
    painter.setFont(large);
    Plate plate{painter.boundingRect(room, kPlateFlags, frame.words), {}, {}};
    painter.setFont(usual);
    if (!frame.more.isEmpty()) plate.more = painter.boundingRect(room, kPlateFlags, frame.more);
    plate.words.moveTop(place.center().y() - (plate.words.height() + plate.more.height()) / 2);
    plate.more.moveTop(plate.words.bottom() + 1);
    plate.box = (plate.more.isEmpty() ? plate.words : plate.words.united(plate.more)).adjusted(-kAround, -kAbove, kAround, kAbove);
    return plate;
}

QRect drawPlate(QPainter& painter, const QRect& place, const PictureFrame& frame, const QRect& avoided) {
    QFont large = painter.font();
    large.setBold(true);
    Plate plate;
    for (const double factor : {2.0, 1.5, 1.0}) { // a narrow view has no room for the largest letters next to a picture
        large.setPointSizeF(painter.font().pointSizeF() * factor);
        plate = plateIn(painter, place, frame, large);
        if (!plate.box.intersects(avoided)) break;
        plate = plateIn(painter, place.adjusted(0, 0, avoided.left() - place.right() - 1, 0), frame, large);
        if (!plate.box.intersects(avoided)) break;
    }
    painter.setPen(QPen(frame.colour, 2.0));
    painter.setBrush(QColor(27, 29, 31));
    painter.drawRect(plate.box);
    painter.setPen(Qt::white);
    painter.drawText(plate.more, kPlateFlags, frame.more);
    painter.setFont(large);
    painter.drawText(plate.words, kPlateFlags, frame.words);
    return plate.box;
}

} // namespace

QRect drawPictureFrame(QPainter& painter, const QRect& place, const PictureFrame& frame, const QRect& avoided) {
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
    const QRect plate = frame.words.isEmpty() ? QRect() : drawPlate(painter, place, frame, avoided);
    painter.restore();
    return plate;
}

} // namespace edgescan::ui
