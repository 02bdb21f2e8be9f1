// A narrow strip at the right edge with an icon of each folded panel. One press opens the panel.
#pragma once

#include <QToolBar>

class QDockWidget;

namespace edgescan::ui {

/// Visible only while at least one of its panels is folded. Each panel's title bar gets a button that folds the panel.
class DockRail : public QToolBar {
    Q_OBJECT
public:
    explicit DockRail(QWidget* parent = nullptr);

    void add(QDockWidget* dock);

    /// While locked the rail is hidden.
    void setLocked(bool on);

signals:
    /// The operator folded or opened a panel: with its title bar, the rail or the menu. A change of the window's width does not emit this.
    void changedByOperator(QDockWidget* dock, bool open);

private:
    void showFolded();

    QList<QDockWidget*> docks_;
    bool locked_ = false;
};

} // namespace edgescan::ui
