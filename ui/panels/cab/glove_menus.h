// Menus for gloves: each has an entry that closes it, and a tap next to it does nothing else.
#pragma once

#include <QObject>

class QAction;
class QMenu;

namespace edgescan::ui {

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
    void take(QMenu& menu);

    QAction *close_, *end_;
    bool on_ = false;
    bool scrolling_ = false; // by the tap that is pressed
};

} // namespace edgescan::ui
