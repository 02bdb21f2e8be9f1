// Names and counts of cell states, and range limits.
#include "core/scan/grid/scan.h"

#include "core/base/simd.h"

#include <algorithm>
#include <limits>

namespace edgescan {
namespace {

EDGESCAN_INLINE std::size_t countOf(CellState state, const CellState* states, int beams) {
    int count = 0;
    for (int j = 0; j < beams; ++j) count += states[j] == state ? 1 : 0;
    return static_cast<std::size_t>(count);
}

// Limits of every 64th cell. For a single limit the compiler could vectorise only if it may reorder, and it processes an array of 16 one by
// one.
struct LimitsOfLane {
    static constexpr int kLaneCount = 64;
    std::array<float, kLaneCount> least, most;
    LimitsOfLane() {
        least.fill(std::numeric_limits<float>::infinity());
        most.fill(-std::numeric_limits<float>::infinity());
    }
};

EDGESCAN_INLINE void updateLimits(const float* rangeMm, const CellState* states, int beams, LimitsOfLane& lanes) {
    constexpr int kLaneCount = LimitsOfLane::kLaneCount;
    LimitsOfLane found = lanes; // on the stack, so that reading the grid cannot change it
    int j = 0;
    for (; j + kLaneCount <= beams; j += kLaneCount) {
        for (int n = 0; n < kLaneCount; ++n) {
            const float range = rangeMm[j + n];
            const bool valid = states[j + n] == CellState::Valid;
            found.least[n] = valid & (range < found.least[n]) ? range : found.least[n];
            found.most[n] = valid & (range > found.most[n]) ? range : found.most[n];
        }
    }
    for (; j < beams; ++j) {
        if (states[j] != CellState::Valid) continue;
        found.least[0] = std::min(found.least[0], rangeMm[j]);
        found.most[0] = std::max(found.most[0], rangeMm[j]);
    }
    lanes = found;
}

} // namespace

const char* cellStateName(CellState state) {
    static constexpr std::array<const char*, kCellStates> names{"valid", "no_return", "status", "out_of_window", "masked", "lost"};
    return names[static_cast<std::size_t>(state)];
}

std::array<std::size_t, kCellStates> countCells(const Scan& scan) {
    std::array<std::size_t, kCellStates> counts{};
    for (int i = 0; i < scan.state.lines; ++i) {
        for (std::size_t s = 0; s < counts.size(); ++s)
            counts[s] += vectorised<countOf>(static_cast<CellState>(s), scan.state.line(i), scan.state.beams);
    }
    return counts;
}

RangeLimits rangeLimits(const Scan& scan) {
    LimitsOfLane lanes;
    for (int i = 0; i < scan.lines(); ++i) vectorised<updateLimits>(scan.rangeMm.line(i), scan.state.line(i), scan.beams(), lanes);
    const RangeLimits limits{*std::ranges::min_element(lanes.least), *std::ranges::max_element(lanes.most)};
    return limits.minMm <= limits.maxMm ? limits : RangeLimits{};
}

} // namespace edgescan
