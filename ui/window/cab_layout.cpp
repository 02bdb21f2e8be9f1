// Changes of the window's layout in cab mode.
#include "ui/base/pane.h"
#include "ui/views/cloud/cloud_view.h"
#include "ui/window/cab_mode.h"
#include "ui/window/docks.h"
#include "ui/window/main_window.h"
#include "ui/window/side_column.h"
#include "ui/window/tool_bar.h"

#include <QBoxLayout>

namespace edgescan::ui {

void MainWindow::useCab(bool on) {
    viewsRow_->setDirection(on ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
    side_->setStrip(on);
    side_->setVisible(on); // on the desk where it has room: arrange()
    viewer_.tools.setVisible(!on);
    findChild<QToolBar*>("badge-bar")->setVisible(!on); // the head of the cab has its own badge
    showAlone(on ? &viewer_.cloud : nullptr);
    for (Pane* pane : panes_) pane->setTitled(!on); // the corner picture has its own text
}

void MainWindow::lockDocks(DockLock by, bool on) { docks_->setLocked(by, on); }

void MainWindow::showAlone(const QWidget* view) {
    Pane* wanted = nullptr;
    for (Pane* pane : panes_) wanted = pane->content() == view ? pane : wanted;
    if (maximised_ != nullptr) maximise(maximised_);
    if (wanted != nullptr) maximise(wanted);
}

} // namespace edgescan::ui
