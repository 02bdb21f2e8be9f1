// Turns the mouse wheel over a widget.
#pragma once

#include <QApplication>
#include <QWheelEvent>
#include <QWidget>

namespace edgescan::ui {

inline void wheel(QWidget& view, QPoint at, int notches, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QWheelEvent event(at, view.mapToGlobal(at), QPoint(), QPoint(0, 120 * notches), Qt::NoButton, modifiers, Qt::NoScrollPhase, false);
    QApplication::sendEvent(&view, &event);
}

} // namespace edgescan::ui
