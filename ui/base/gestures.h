// How all views read the mouse.
#pragma once

#include <QLineF>
#include <QMouseEvent>
#include <QWheelEvent>

namespace edgescan::ui {

/// Qt 5 and Qt 6 name the position of a mouse event differently.
[[nodiscard]] inline QPointF place(const QMouseEvent& event) {
#if QT_VERSION >= QT_VERSION_CHECK(6, 0, 0)
    return event.position();
#else
    return event.localPos();
#endif
}

/// The effect of dragging with the left button over a picture.
enum class DragTool {
    Move,  ///< moves the picture, or turns the cloud
    Box,   ///< selects the cells in a box
    Lasso, ///< selects the cells inside a free-hand outline
};

/// A mouse button while it is pressed.
struct Press {
    Qt::MouseButton button = Qt::NoButton;
    QPointF from, last;
    bool travelled = false; ///< further than a click

    void begin(const QMouseEvent& event) { *this = {event.button(), place(event), place(event), false}; }
    /// False while the press can still become a click. The caller updates `last`.
    bool travels(QPointF at) {
        constexpr double kClickPx = 4.0;
        return travelled = travelled || QLineF(from, at).length() >= kClickPx;
    }
};

/// Left, without a key that gives the click another meaning: it chooses the target or the measurement whose mark is there.
[[nodiscard]] inline bool choosesMarks(const QMouseEvent& event) {
    return event.button() == Qt::LeftButton && !(event.modifiers() & (Qt::ShiftModifier | Qt::ControlModifier));
}

/// Notches of the wheel, positive away from the operator. With Alt pressed, X11 and Qt report a horizontal wheel movement.
[[nodiscard]] inline double notches(const QWheelEvent& event) {
    const QPoint angle = event.angleDelta();
    return (angle.y() != 0 ? angle.y() : angle.x()) / 120.0;
}

} // namespace edgescan::ui
