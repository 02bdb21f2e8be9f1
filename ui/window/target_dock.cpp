// Places the panel of targets in the window.
#include "ui/window/target_dock.h"

#include "ui/base/scrolled.h"
#include "ui/controllers/targets/targets.h"
#include "ui/panels/targets/targets_panel.h"

#include <QAction>
#include <QDockWidget>
#include <QGuiApplication>
#include <QMainWindow>
#include <QScreen>
#include <QScrollArea>

namespace edgescan::ui {
namespace {

constexpr int kOpensFrom = 1100;          // px of the window: in a narrower one only the operator opens the panel
constexpr int kLowScreen = 1000;          // px: on a lower screen rocks and targets share a place
constexpr double kTargetsHeight = 0.55;   // of the window
constexpr const char* kClosed = "closed"; // by the operator: a new target does not open it again

} // namespace

void addTargetDock(QMainWindow& window, Targets& targets, TargetsPanel& panel) {
    auto* dock = new QDockWidget(QObject::tr("Targets"), &window);
    dock->setObjectName("dock-targets");
    dock->setWidget(scrolled(panel));
    window.addDockWidget(Qt::RightDockWidgetArea, dock);
    dock->hide();
    // On a low screen one whole card is easier to read than a third of each.
    auto* rocks = window.findChild<QDockWidget*>("dock-rocks");
    if (rocks != nullptr && QGuiApplication::primaryScreen()->availableGeometry().height() < kLowScreen) {
        window.setTabPosition(Qt::RightDockWidgetArea, QTabWidget::North);
        window.tabifyDockWidget(rocks, dock);
        QObject::connect(rocks->toggleViewAction(), &QAction::toggled, rocks, [rocks](bool open) {
            if (open) rocks->raise();
        });
    }
    QObject::connect(dock->toggleViewAction(), &QAction::toggled, dock, [dock](bool open) { dock->setProperty(kClosed, !open); });
    QObject::connect(&targets, &Targets::pinned, dock, [&window, dock] {
        if (!dock->isHidden() || dock->property(kClosed).toBool() || window.width() < kOpensFrom) return;
        if (window.property("docksLocked").toBool()) return;
        dock->show();
        window.resizeDocks({dock}, {static_cast<int>(kTargetsHeight * window.height())}, Qt::Vertical);
    });
}

} // namespace edgescan::ui
