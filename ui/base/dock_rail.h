// A narrow strip at the right edge with an icon of each folded panel. One press opens the panel.
#pragma once

#include <QToolBar>

class QAction;
class QDockWidget;

namespace edgescan::ui {

/// Visible only while at least one of its panels is folded. Each panel's title bar gets a button that folds the panel.
class DockRail : public QToolBar {
    Q_OBJECT
public:
    explicit DockRail(QWidget* parent = nullptr);

    void add(QDockWidget* dock);
    /// Whether the strip has its name while it is folded; true at first.
    void setWanted(const QDockWidget* dock, bool on);

    /// While locked the rail is hidden.
    void setLocked(bool on);

private:
    struct Folded {
        const QDockWidget* dock;
        QAction* place; // of its name
        bool wanted = true;
    };
    void showFolded();

    QList<Folded> docks_;
    bool locked_ = false;
};

} // namespace edgescan::ui
