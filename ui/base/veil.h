// What lies over a picture that is older than it seems: gray over everything, and why in large letters.
#pragma once

#include <QPainter>
#include <QString>

namespace edgescan::ui {

inline const QColor kVeil(104, 104, 104, 170);

inline void drawVeil(QPainter& painter, const QRect& place, const QString& why) {
    painter.fillRect(place, kVeil);
    QFont large = painter.font();
    large.setBold(true);
    large.setPointSizeF(large.pointSizeF() * 2.0);
    painter.setFont(large);
    const QRect box = painter.boundingRect(place, Qt::AlignCenter | Qt::TextWordWrap, why).adjusted(-12, -6, 12, 6);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(0, 0, 0, 200));
    painter.drawRect(box);
    painter.setPen(Qt::white);
    painter.drawText(box, Qt::AlignCenter | Qt::TextWordWrap, why);
}

} // namespace edgescan::ui
