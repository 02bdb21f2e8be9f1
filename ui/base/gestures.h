// What the views share in reading the mouse.
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

/// What the left button's drag does over a picture.
enum class DragTool {
    Move,  ///< moves the picture, or turns the cloud
    Box,   ///< selects what a box holds
    Lasso, ///< selects what a line drawn by hand goes round
};

/// One button that is held down.
struct Press {
    Qt::MouseButton button = Qt::NoButton;
    QPointF from, last;
    bool travelled = false; ///< further than a click

    void begin(const QMouseEvent& event) { *this = {event.button(), place(event), place(event), false}; }
    /// False as long as it can still become a click. `last` is for the caller to move on.
    bool travels(QPointF at) {
        constexpr double kClickPx = 4.0;
        return travelled = travelled || QLineF(from, at).length() >= kClickPx;
    }
};

/// Notches of the wheel, away from the hand positive. With Alt held X11 and Qt turn the wheel sideways.
[[nodiscard]] inline double notches(const QWheelEvent& event) {
    const QPoint angle = event.angleDelta();
    return (angle.y() != 0 ? angle.y() : angle.x()) / 120.0;
}

} // namespace edgescan::ui
