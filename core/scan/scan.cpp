// Names and counts of a scan's cells.
#include "core/scan/scan.h"

#include <algorithm>

namespace edgescan {

const char* cellStateName(CellState state) {
    static constexpr std::array<const char*, kCellStates> names{"valid", "no_return", "status", "out_of_window", "masked", "lost"};
    return names[static_cast<std::size_t>(state)];
}

std::array<std::size_t, kCellStates> countCells(const Scan& scan) {
    std::array<std::size_t, kCellStates> counts{};
    for (const CellState state : scan.state.cells) ++counts[static_cast<std::size_t>(state)];
    return counts;
}

RangeLimits rangeLimits(const Scan& scan) {
    RangeLimits limits;
    bool any = false;
    for (std::size_t k = 0; k < scan.cells(); ++k) {
        if (scan.state[k] != CellState::Valid) continue;
        const float range = scan.rangeMm[k];
        limits.minMm = any ? std::min(limits.minMm, range) : range;
        limits.maxMm = any ? std::max(limits.maxMm, range) : range;
        any = true;
    }
    return limits;
}

} // namespace edgescan
