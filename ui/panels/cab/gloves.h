// Menus and scrolling for gloves: a menu has an entry that closes it, a swipe scrolls, and a tap next to a menu does nothing else.
#pragma once

#include <QObject>
#include <QPoint>
#include <QPointer>

class QAction;
class QMenu;
class QMouseEvent;
class QAbstractScrollArea;

namespace edgescan::ui {

/// GUI thread only. While it is on, a drag with the left button scrolls each page that is higher than its room, and each list. A tap still
/// presses what is below it, and a drag across still moves a slider. Lists of boxes are popups and scroll by their arrows.
class Swipes : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;
    ~Swipes() override;

    void setOn(bool on);

    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    static void grab(QAbstractScrollArea& area);
    static void giveBack(QAbstractScrollArea& area);
};

/// GUI thread only. While it is on, every menu of the program begins with Close: on a small screen a menu covers all that could be tapped
/// to close it.
class GloveMenus : public QObject {
    Q_OBJECT
public:
    explicit GloveMenus(QObject* parent = nullptr);
    ~GloveMenus() override;

    void setOn(bool on);
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void addMenu(QMenu& menu);
    bool readMouse(QMenu& opened, const QMouseEvent& event);
    void swipe(int y);

    QAction *close_, *end_;
    bool on_ = false;
    QPointer<QMenu> pressed_; // the menu under the finger
    QPoint from_;             // where the press was, and after that where the last entry was scrolled
    bool scrolling_ = false;  // the press scrolls: its release chooses nothing
};

} // namespace edgescan::ui
