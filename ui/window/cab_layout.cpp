// Changes of the window's layout in cab mode.
#include "ui/base/dock_rail.h"
#include "ui/base/pane.h"
#include "ui/views/cloud/cloud_view.h"
#include "ui/window/cab_mode.h"
#include "ui/window/main_window.h"
#include "ui/window/tool_bar.h"

#include <QAction>
#include <QDockWidget>

#include <utility>

namespace edgescan::ui {

void MainWindow::useCab(bool on) {
    viewer_.tools.setVisible(!on);
    findChild<QToolBar*>("badge-bar")->setVisible(!on); // the head of the cab has its own badge
    showAlone(on ? &viewer_.cloud : nullptr);
    for (Pane* pane : panes_) pane->setTitled(!on); // the corner picture has its own text
}

/// While locked no dock is visible: the switches of docks are disabled, and nothing else opens a dock.
void MainWindow::lockDocks(bool on) {
    setProperty("docksLocked", on);
    rail_->setLocked(on);
    for (auto* dock : findChildren<QDockWidget*>()) {
        dock->toggleViewAction()->setEnabled(!on);
        if (on && !dock->isHidden()) hiddenForCab_ << dock;
        if (on) dock->hide();
    }
    if (on) return;
    for (QDockWidget* dock : std::exchange(hiddenForCab_, {})) {
        if (!docks_.contains(dock)) dock->show(); // for the other docks the width decides
    }
    arrange();
}

void MainWindow::showAlone(const QWidget* view) {
    Pane* wanted = nullptr;
    for (Pane* pane : panes_) wanted = pane->content() == view ? pane : wanted;
    if (maximised_ != nullptr) maximise(maximised_);
    if (wanted != nullptr) maximise(wanted);
}

} // namespace edgescan::ui
