// What the views share in reading mouse and touch: the place of an event, how far a click may travel, a pinch in an event.
#pragma once

#include <QGestureEvent>
#include <QMouseEvent>
#include <QPinchGesture>

namespace edgescan::ui {

inline constexpr double kClickPx = 4.0; ///< less travel than this is a click

/// Qt 5 and Qt 6 name the position of a mouse event differently.
[[nodiscard]] inline QPointF place(const QMouseEvent& event) {
#if QT_VERSION >= QT_VERSION_CHECK(6, 0, 0)
    return event.position();
#else
    return event.localPos();
#endif
}

/// The pinch that the event carries, accepted; null when it carries none.
[[nodiscard]] inline const QPinchGesture* acceptedPinch(QEvent* event) {
    if (event->type() != QEvent::Gesture) return nullptr;
    auto* gestures = static_cast<QGestureEvent*>(event);
    auto* pinch = static_cast<QPinchGesture*>(gestures->gesture(Qt::PinchGesture));
    if (pinch != nullptr) gestures->accept(pinch);
    return pinch;
}

} // namespace edgescan::ui
