// Range gate and clip box: hide cells by their position.
#include "ui/base/notice_bar.h"
#include "ui/base/undo_step.h"
#include "ui/controllers/targets/selection.h"
#include "ui/engine/linked_views/linked_views.h"
#include "ui/engine/worker_bridge/engine.h"
#include "ui/panels/dialogs/range_gate_dialog.h"

#include <limits>

namespace edgescan::ui {

void Selection::hideToo(const QString& what, const inspect::CellSet& cells) {
    if (cells.empty())
        notice_.showNotice(NoticeBar::Kind::Done, tr("There is no cell here: nothing more is hidden."));
    else
        change(what, {inspect::without(state_.selected, cells), inspect::united(state_.hidden, cells)});
    reportGrowth();
}

void Selection::reportGrowth() {
    if (!engine_.picture() || !engine_.picture()->source.growth.growing) return;
    notice_.showNotice(NoticeBar::Kind::Warning,
                       tr("▲ The sweep grows. The cells that are there now are hidden. New lines are shown at every range."));
}

void Selection::setPart(const inspect::SelectionPart& part) {
    const std::size_t cells = engine_.picture()->detection->scan->cells();
    change(stepName("Open Session"), {inspect::cellsOf(part.selected, cells), inspect::cellsOf(part.hidden, cells)});
}

void Selection::hideBeyond(double nearM, double farM) {
    if (engine_.picture()) hideToo(stepName("Range Gate"), inspect::cellsBeyond(*engine_.picture()->detection->scan, nearM, farM));
}

std::optional<double> Selection::rangeAt(std::optional<std::size_t> cell) {
    if (engine_.picture() && cell && *cell < engine_.picture()->detection->scan->cells()) {
        const Scan& scan = *engine_.picture()->detection->scan;
        if (scan.state[*cell] == CellState::Valid) return static_cast<double>(scan.rangeMm[*cell]) / 1000.0;
    }
    notice_.showHint(tr("No range is known there: click a cell, or point at one that has a range, first."));
    return std::nullopt;
}

void Selection::hideFartherThan(std::optional<std::size_t> cell) {
    if (const auto range = rangeAt(cell)) hideBeyond(0.0, *range);
}

void Selection::hideNearerThan(std::optional<std::size_t> cell) {
    if (const auto range = rangeAt(cell)) hideBeyond(*range, std::numeric_limits<double>::infinity());
}

void Selection::askRangeGate() {
    if (!engine_.picture()) return;
    const RangeLimits limits = rangeLimits(*engine_.picture()->detection->scan);
    const auto gate =
        askForRangeGate(notice_.window(), static_cast<double>(limits.minMm) / 1000.0, static_cast<double>(limits.maxMm) / 1000.0);
    if (gate) hideBeyond(gate->nearM, gate->farM);
}

void Selection::clipToSelected() {
    if (!needSelection()) return;
    const Scan& scan = *engine_.picture()->detection->scan;
    const inspect::CellSet outside = inspect::cellsOutsideBoxOf(scan, state_.selected);
    // The selection defined the corners of the box; now its content is of interest.
    if (outside.empty()) return hideToo(stepName("Clip to Box"), outside);
    change(stepName("Clip to Box"), {{}, inspect::united(state_.hidden, outside)});
    reportGrowth();
}

} // namespace edgescan::ui
