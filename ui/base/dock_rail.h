// A narrow strip at the right edge with a name for each panel that is folded away: one press opens it.
#pragma once

#include <QToolBar>

class QDockWidget;

namespace edgescan::ui {

/// Seen only while at least one of its panels is folded. A panel's own head gets a button that folds it.
class DockRail : public QToolBar {
    Q_OBJECT
public:
    explicit DockRail(QWidget* parent = nullptr);

    void add(QDockWidget* dock);

    /// Not there at all until it is off again.
    void setLocked(bool on);

signals:
    /// By the button in the head, by the rail or by the menu, not because the window became wide or narrow.
    void changedByHand(QDockWidget* dock, bool open);

private:
    void showFolded();

    QList<QDockWidget*> docks_;
    bool locked_ = false;
};

} // namespace edgescan::ui
