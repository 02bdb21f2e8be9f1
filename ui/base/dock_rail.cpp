// The strip of folded panels.
#include "ui/base/dock_rail.h"

#include "ui/base/icons.h"

#include <QAction>
#include <QDockWidget>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

namespace edgescan::ui {
namespace {

constexpr int kSign = 22, kWide = 40; // px: of an icon and of its button

/// The icons of the panels, by object name.
struct PanelSign {
    const char* dock;
    const char* sign;
};
constexpr PanelSign kPanelSigns[] = {
    {"dock-edges", "tune"}, {"dock-rocks", "rocks"}, {"dock-rock-table", "table"}, {"dock-targets", "pin"}, {"dock-layers", "layers"}};

QIcon signOf(const QDockWidget& dock) {
    for (const PanelSign& each : kPanelSigns) {
        if (dock.objectName() == each.dock) return toolIcon(each.sign);
    }
    return toolIcon("panel");
}

QWidget* headOf(QDockWidget* dock) {
    auto* head = new QWidget;
    auto* row = new QHBoxLayout(head);
    row->setContentsMargins(8, 2, 4, 2);
    auto* name = new QLabel(dock->windowTitle());
    QFont bold = name->font();
    bold.setBold(true);
    name->setFont(bold);
    row->addWidget(name, 1);
    auto* fold = new QToolButton;
    fold->setObjectName("fold");
    fold->setText("»");
    fold->setAutoRaise(true);
    fold->setToolTip(QObject::tr("Fold this panel to the edge of the window"));
    QObject::connect(fold, &QToolButton::clicked, dock->toggleViewAction(), &QAction::trigger);
    row->addWidget(fold);
    return head;
}

} // namespace

DockRail::DockRail(QWidget* parent) : QToolBar(parent) {
    setObjectName("rail");
    setWindowTitle(tr("Folded panels"));
    setMovable(false);
    setContextMenuPolicy(Qt::PreventContextMenu);
    toggleViewAction()->setVisible(false);
    hide();
}

void DockRail::add(QDockWidget* dock) {
    dock->setTitleBarWidget(headOf(dock));
    auto* button = new QToolButton;
    button->setObjectName("rail-" + dock->objectName());
    button->setIcon(signOf(*dock));
    button->setIconSize({kSign, kSign});
    button->setFixedSize(kWide, kWide);
    button->setAutoRaise(true);
    button->setAccessibleName(dock->windowTitle());
    button->setToolTip(tr("Open %1").arg(dock->windowTitle()));
    docks_.push_back({dock, addWidget(button)});
    connect(button, &QToolButton::clicked, dock->toggleViewAction(), &QAction::trigger);
    connect(dock, &QDockWidget::visibilityChanged, this, &DockRail::showFolded);
    connect(dock->toggleViewAction(), &QAction::toggled, this, &DockRail::showFolded);
    showFolded();
}

void DockRail::setWanted(const QDockWidget* dock, bool on) {
    for (Folded& each : docks_) {
        if (each.dock == dock) each.wanted = on;
    }
    showFolded();
}

void DockRail::setLocked(bool on) {
    locked_ = on;
    showFolded();
}

void DockRail::showFolded() {
    bool any = false;
    for (const Folded& each : docks_) {
        const bool folded = each.wanted && each.dock->isHidden();
        each.place->setVisible(folded);
        any = any || folded;
    }
    setVisible(any && !locked_);
}

} // namespace edgescan::ui

#include "moc_dock_rail.cpp"
