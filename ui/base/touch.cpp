// Turns touches into mouse events.
#include "ui/base/touch.h"

#include "ui/base/gestures.h"

#include <QApplication>
#include <QTouchEvent>
#include <QWidget>

#include <algorithm>
#include <utility>
#include <vector>

namespace edgescan::ui {
namespace {

constexpr double kStillPx = 10.0; // a resting finger always moves a little
constexpr double kLeastSpreadPx = 8.0;

std::vector<QPointF> fingersOf(const QTouchEvent& event) {
    std::vector<QPointF> places;
#if QT_VERSION >= QT_VERSION_CHECK(6, 0, 0)
    for (const QEventPoint& point : event.points()) {
        if (point.state() != QEventPoint::Released) places.push_back(point.position());
    }
#else
    for (const QTouchEvent::TouchPoint& point : event.touchPoints()) {
        if (point.state() != Qt::TouchPointReleased) places.push_back(point.pos());
    }
#endif
    return places;
}

} // namespace

Touch::Touch(QWidget& view, Pinch pinch) : view_(view), pinch_(std::move(pinch)) {
    view.setAttribute(Qt::WA_AcceptTouchEvents);
    rest_.setSingleShot(true);
    rest_.setInterval(kLongPressMs);
    connect(&rest_, &QTimer::timeout, this, &Touch::rest);
}

bool Touch::read(QEvent* event) {
    if (sending_) return false;
    switch (event->type()) {
    case QEvent::TouchBegin:
        if (isOverChild(*static_cast<QTouchEvent*>(event))) {
            event->ignore(); // a button or a plate over the view: Qt sends it the mouse event instead
            return true;
        }
        [[fallthrough]];
    case QEvent::TouchUpdate:
    case QEvent::TouchEnd:
        event->accept();
        return readTouch(*static_cast<QTouchEvent*>(event));
    case QEvent::TouchCancel:
        giveUp();
        middle_.reset();
        return true;
    case QEvent::MouseButtonPress:
    case QEvent::MouseMove:
    case QEvent::MouseButtonRelease:
    case QEvent::MouseButtonDblClick: {
        const auto& mouse = *static_cast<QMouseEvent*>(event);
        return isOfAnother(mouse) || (mouseIsFinger_ && readMouse(mouse));
    }
    default:
        return false;
    }
}

// A double click whose first half another widget received: it opened the scan from the start page, or closed what covered the view.
bool Touch::isOfAnother(const QMouseEvent& event) {
    if (event.type() == QEvent::MouseButtonPress) {
        ofAnother_ = false;
        pressedAt_ = event.timestamp();
    } else if (event.type() == QEvent::MouseButtonDblClick) {
        const auto longest = static_cast<unsigned long>(QApplication::doubleClickInterval());
        ofAnother_ = !pressedAt_ || event.timestamp() - *pressedAt_ > longest;
    } else if (event.type() == QEvent::MouseButtonRelease) {
        return std::exchange(ofAnother_, false);
    }
    return ofAnother_;
}

bool Touch::isOverChild(const QTouchEvent& event) const {
    const std::vector<QPointF> fingers = fingersOf(event);
    return !fingers.empty() && view_.childAt(fingers.front().toPoint()) != nullptr;
}

bool Touch::readTouch(const QTouchEvent& event) {
    const std::vector<QPointF> fingers = fingersOf(event);
    if (event.type() == QEvent::TouchBegin) {
        finger_.reset();
        middle_.reset();
    }
    if (fingers.size() >= 2) {
        giveUp();
        const QPointF middle = (fingers[0] + fingers[1]) / 2.0;
        const double spread = std::max(kLeastSpreadPx, QLineF(fingers[0], fingers[1]).length());
        if (middle_) pinch_(middle, middle - *middle_, spread / spread_);
        middle_ = middle;
        spread_ = spread;
        return true;
    }
    if (fingers.empty()) {
        if (finger_) end(finger_->at);
        middle_.reset();
        return true;
    }
    if (middle_) return true; // one of two fingers was lifted: the other one is ignored
    finger_ ? move(fingers.front()) : begin(fingers.front());
    return true;
}

// The press event is delayed until the kind of gesture is known.
bool Touch::readMouse(const QMouseEvent& event) {
    const bool moves = event.type() == QEvent::MouseMove;
    if (moves ? !finger_ : event.button() != Qt::LeftButton) return false;
    if (event.type() == QEvent::MouseButtonPress || event.type() == QEvent::MouseButtonDblClick)
        begin(place(event));
    else if (moves)
        move(place(event));
    else if (finger_)
        end(place(event));
    return true;
}

void Touch::begin(QPointF at) {
    finger_ = Finger{at, at};
    rest_.start();
}

void Touch::move(QPointF at) {
    finger_->at = at;
    if (finger_->spent) return;
    if (!finger_->pressed) {
        if (QLineF(finger_->from, at).length() < kStillPx) return;
        rest_.stop();
        finger_->pressed = true;
        send(QEvent::MouseButtonPress, finger_->from, Qt::LeftButton);
    }
    send(QEvent::MouseMove, at, Qt::LeftButton);
}

void Touch::end(QPointF at) {
    rest_.stop();
    const Finger was = *std::exchange(finger_, std::nullopt);
    if (was.spent) return;
    if (!was.pressed) send(QEvent::MouseButtonPress, was.from, Qt::LeftButton);
    send(QEvent::MouseButtonRelease, was.pressed ? at : was.from, Qt::LeftButton);
}

void Touch::giveUp() {
    rest_.stop();
    if (!finger_) return;
    if (finger_->pressed && !finger_->spent) send(QEvent::MouseButtonRelease, finger_->at, Qt::LeftButton);
    finger_->spent = true;
}

// The finger rested where it touched: sent as the right button.
void Touch::rest() {
    if (!finger_ || finger_->pressed || finger_->spent) return;
    finger_->spent = true;
    const QPointF at = finger_->from;
    send(QEvent::MouseButtonPress, at, Qt::RightButton);
    send(QEvent::MouseButtonRelease, at, Qt::RightButton); // may open a menu; returns when the menu is closed
}

void Touch::send(int type, QPointF at, Qt::MouseButton button) {
    const auto kind = static_cast<QEvent::Type>(type);
    const bool moves = kind == QEvent::MouseMove;
    QMouseEvent event(kind, at, view_.mapToGlobal(at.toPoint()), moves ? Qt::NoButton : button,
                      kind == QEvent::MouseButtonRelease ? Qt::NoButton : button, Qt::NoModifier);
    const bool before = std::exchange(sending_, true);
    QApplication::sendEvent(&view_, &event);
    sending_ = before;
}

} // namespace edgescan::ui
