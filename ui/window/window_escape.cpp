// What Esc ends.
#include "ui/base/notice_bar.h"
#include "ui/panels/live/live_panel.h"
#include "ui/window/cab_mode.h"
#include "ui/window/first_tour.h"
#include "ui/window/main_window.h"

#include <QAbstractSpinBox>
#include <QKeyEvent>

namespace edgescan::ui {

void MainWindow::keyPressEvent(QKeyEvent* event) {
    const bool isEnter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    auto* number = qobject_cast<QAbstractSpinBox*>(focusWidget());
    if (number != nullptr && (isEnter || event->key() == Qt::Key_Escape))
        number->clearFocus(); // the next key is a command
    else if (event->key() == Qt::Key_Escape)
        escape();
    else if (event->key() != Qt::Key_Backspace || !viewer_.measures.removeLastPick())
        QMainWindow::keyPressEvent(event);
}

// One press ends one thing, whichever view has the keyboard focus; docs/guide/keys.md has this order.
void MainWindow::escape() {
    if (viewer_.engine.opening()) { // a save or a comparison has its button
        viewer_.engine.cancel();
        viewer_.notice.showHint(tr("Cancelled; what was on the screen stays."));
        return;
    }
    if (leaveTool() || viewer_.explanation.closeCard() || viewer_.notice.fold()) return;
    if (viewer_.notice.isVisible())
        viewer_.notice.closeShown();
    else if (viewer_.livePanel.closeAddress())
        return;
    else if (maximised_ != nullptr && !cab_->on())
        maximise(maximised_);
    else if (endTour(*this))
        viewer_.notice.showHint(tr("The tour has ended; Help > Tour begins it again."));
    else if (!viewer_.selection.cells().empty())
        viewer_.selection.select({});
    else if (viewer_.sections.close())
        return;
    else {
        viewer_.views.clearPin();
        viewer_.targets.chooseMeasure(std::nullopt);
        viewer_.rocks.select({});
    }
}

/// With its unfinished clicks, and the hint about them. False: no tool is in use.
bool MainWindow::leaveTool() {
    const bool isRocks = viewer_.rocks.tool() != RockTool::None;
    const Tool tool = viewer_.views.tool();
    const bool pinsOnRocks = tool == Tool::Pin && viewer_.rocks.shown() && !viewer_.views.choosesOnly();
    if (!isRocks && !pinsOnRocks && (tool == Tool::Pin || tool == Tool::Why)) return false; // Why ends with its card
    isRocks ? viewer_.rocks.useTool(RockTool::None) : viewer_.views.setTool(Tool::Pin);
    if (pinsOnRocks) viewer_.views.setChoosesOnly(true);
    viewer_.notice.endPassing();
    return true;
}

} // namespace edgescan::ui
