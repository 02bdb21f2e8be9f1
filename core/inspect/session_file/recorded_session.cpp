// Sessions of a sweep that is being recorded.
#include "core/base/sha256.h"
#include "core/inspect/session_file/viewer_state.h"
#include "core/scan/grid/scan_time.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace edgescan::inspect {
namespace {

void cut(std::vector<CellRun>& runs, std::size_t cells) {
    std::erase_if(runs, [cells](const CellRun& run) { return run.first >= cells; });
    if (!runs.empty()) runs.back().count = static_cast<std::uint32_t>(std::min<std::size_t>(runs.back().count, cells - runs.back().first));
}

} // namespace

ScanHead scanHead(const Scan& scan, int lines) {
    const int taken = std::min(lines, scan.lines());
    const std::size_t cells = static_cast<std::size_t>(taken) * static_cast<std::size_t>(scan.beams());
    return {taken, sha256Hex(std::as_bytes(std::span(scan.rangeMm.cells).first(cells)))};
}

bool isSweepOf(const SessionScan& scan, const Scan& sweep) {
    const double startS = startOfScan(sweep).value_or(0.0);
    const bool otherStart = scan.startS > 0.0 && startS > 0.0 && std::abs(startS - scan.startS) > kSameStartS;
    return !otherStart && sweep.beams() == scan.identity.beams && scanHead(sweep, scan.head.lines) == scan.head;
}

ViewerState cutTo(ViewerState state, std::size_t cells) {
    const auto gone = [cells](std::uint32_t cell) { return cell >= cells; };
    const auto someGone = [&gone](const auto& one) { return std::ranges::any_of(one.cells, gone); };
    std::erase_if(state.targets.notebook.targets, [&gone](const PinnedTarget& target) { return gone(target.cell); });
    std::erase_if(state.targets.notebook.measures, someGone);
    if (state.targets.active && gone(*state.targets.active)) state.targets.active.reset();
    cut(state.selection.selected, cells);
    cut(state.selection.hidden, cells);
    std::erase_if(state.marks.wanted, gone);
    std::erase_if(state.marks.unwanted, gone);
    if (state.rocks) std::erase_if(state.rocks->edits, someGone);
    return state;
}

} // namespace edgescan::inspect
