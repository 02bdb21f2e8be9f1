// A dark plate over a view.
#include "ui/base/view_plate.h"

#include "ui/base/themes.h"

#include <QPainter>

namespace edgescan::ui {

ViewPlate::ViewPlate(QWidget* parent) : QFrame(parent) { setPalette(viewPalette()); }

void ViewPlate::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QColor(0x63, 0x68, 0x6e));
    painter.setBrush(QColor(0x1b, 0x1d, 0x1f));
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4.0, 4.0);
}

} // namespace edgescan::ui

#include "moc_view_plate.cpp"
