// Places the panel and the table of rocks in the window.
#include "ui/window/rock_docks.h"

#include "ui/base/scrolled.h"
#include "ui/controllers/rocks/rocks.h"
#include "ui/panels/rocks/rock_table.h"
#include "ui/panels/rocks/rocks_panel.h"

#include <QDockWidget>
#include <QMainWindow>
#include <QScrollArea>

namespace edgescan::ui {
namespace {

constexpr int kTableFrom = 1600;     // px of the window: in a narrower one the table opens only on request
constexpr int kTableHeight = 234;    // px
constexpr double kPanelShare = 0.55; // of the window's height

QDockWidget* dockOf(QMainWindow& window, const QString& title, const char* name, QWidget* content, Qt::DockWidgetArea area) {
    auto* dock = new QDockWidget(title, &window);
    dock->setObjectName(name);
    dock->setWidget(content);
    window.addDockWidget(area, dock);
    dock->hide();
    return dock;
}

} // namespace

void addRockDocks(QMainWindow& window, Rocks& rocks, RocksPanel& panel, RockTable& table) {
    window.setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    QDockWidget* right = dockOf(window, QObject::tr("Rocks"), "dock-rocks", scrolled(panel), Qt::RightDockWidgetArea);
    QDockWidget* bottom = dockOf(window, QObject::tr("Rock Table"), "dock-rock-table", &table, Qt::BottomDockWidgetArea);
    QObject::connect(&rocks, &Rocks::shownChanged, &window, [&window, right, bottom](bool on) {
        if (window.property("docksLocked").toBool()) return;
        right->setVisible(on);
        bottom->setVisible(on && window.width() >= kTableFrom);
        if (!on) return;
        window.resizeDocks({bottom}, {kTableHeight}, Qt::Vertical);
        window.resizeDocks({right}, {static_cast<int>(kPanelShare * window.height())}, Qt::Vertical);
    });
}

} // namespace edgescan::ui
