// Fingers on a view: one finger works as the left button, two fingers move and zoom, a resting finger is a right click.
#pragma once

#include <QObject>
#include <QPointF>
#include <QTimer>

#include <functional>
#include <optional>

class QEvent;
class QMouseEvent;
class QTouchEvent;
class QWidget;

namespace edgescan::ui {

inline constexpr int kLongPressMs = 600;

/// GUI thread only. Reads the touch events of one view and sends it mouse events instead.
class Touch : public QObject {
public:
    /// Two fingers: their middle, its movement since the last event, and the factor of their distance (1 = unchanged). Widget pixels.
    using Pinch = std::function<void(QPointF middle, QPointF shift, double factor)>;

    Touch(QWidget& view, Pinch pinch);

    /// Call it first with every event of the view. True: the event is consumed.
    bool read(QEvent* event);
    /// For gloves the left button counts as a finger too: many screens report touches as a mouse.
    void setMouseIsFinger(bool on) { mouseIsFinger_ = on; }
    [[nodiscard]] bool mouseIsFinger() const { return mouseIsFinger_; }

private:
    struct Finger {
        QPointF from, at;
        bool pressed = false; ///< it moved: the view received a press event
        bool spent = false;   ///< it rested, or a second finger touched: its release has no effect
    };
    bool isOfAnother(const QMouseEvent& event);
    [[nodiscard]] bool isOverChild(const QTouchEvent& event) const;
    bool readTouch(const QTouchEvent& event);
    bool readMouse(const QMouseEvent& event);
    void begin(QPointF at);
    void move(QPointF at);
    void end(QPointF at);
    void giveUp();
    void rest();
    void send(int type, QPointF at, Qt::MouseButton button);

    QWidget& view_;
    Pinch pinch_;
    std::optional<Finger> finger_;
    std::optional<QPointF> middle_; // of two fingers, while two are down
    double spread_ = 0.0;
    QTimer rest_;
    std::optional<unsigned long> pressedAt_; // ms, when the view received its last press of the mouse
    bool ofAnother_ = false;                 // the button that is down
    bool mouseIsFinger_ = false;
    bool sending_ = false;
};

} // namespace edgescan::ui
