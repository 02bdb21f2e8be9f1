// Fingers on a view: one does what the left button does, two move and zoom, one that rests is a right click.
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

/// GUI thread only. Reads the events of one view and sends it those of a mouse instead.
class Touch : public QObject {
public:
    /// Two fingers: where their middle is, how far it moved since the last time, by how much they spread (1 = as before). Widget pixels.
    using Pinch = std::function<void(QPointF middle, QPointF shift, double factor)>;

    Touch(QWidget& view, Pinch pinch);

    /// Call it first with every event of the view; true: nobody else may have it.
    bool read(QEvent* event);
    /// For gloves the left button is a finger too: many screens tell touches as a mouse.
    void setMouseIsFinger(bool on) { mouseIsFinger_ = on; }

private:
    struct Finger {
        QPointF from, at;
        bool pressed = false; ///< it moved: the view was told of the button
        bool spent = false;   ///< it rested, or a second one came: nothing follows from its end
    };
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
    std::optional<QPointF> middle_; // of two fingers, while there are two
    double spread_ = 0.0;
    QTimer rest_;
    bool mouseIsFinger_ = false;
    bool sending_ = false;
};

} // namespace edgescan::ui
