// Which cells of a segment touch no other segment, with a margin around the grid.
#pragma once

#include "core/base/simd.h"
#include "core/rocks/segmentation/planes.h"
#include "core/rocks/segmentation/segments.h"
#include "core/scan/grid/inverse_range.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace edgescan::rocks {

/// In `solid`: a cell without a range, and the margin.
inline constexpr std::uint32_t kVoidCell = UINT32_MAX;

/// The segment of a cell. kNoSegment for a cell without a range, and for a cell that touches a cell of another segment or of no segment
/// (of the 8 neighbours, those with a range). `solid`: the cell in a grid with `step` cells per line.
EDGESCAN_INLINE std::uint32_t innerSegment(const std::uint32_t* solid, std::size_t step) {
    const std::uint32_t* const above = solid - step;
    const std::uint32_t* const below = solid + step;
    const std::uint32_t here = *solid;
    std::uint32_t others = here == kVoidCell ? 1U : 0U;
    for (const std::uint32_t there : {above[-1], above[0], above[1], solid[-1], solid[1], below[-1], below[0], below[1]})
        others |= (there != here ? 1U : 0U) & (there != kVoidCell ? 1U : 0U);
    return others != 0 ? kNoSegment : here;
}

/// The segments of a grid with kPlaneReach more cells on each side, and a few more behind them.
class InnerCells {
public:
    /// `threads`: 0 is as many as make it faster.
    InnerCells(const InverseRange& inverse, const Grid<std::uint32_t>& segment, int threads = 0);

    /// Cells of a line with its margin.
    [[nodiscard]] std::size_t beams() const { return beams_; }
    [[nodiscard]] std::size_t index(int line, int beam) const {
        return static_cast<std::size_t>(line + kPlaneReach) * beams_ + static_cast<std::size_t>(beam + kPlaneReach);
    }
    /// Whether the cell has a range and touches another segment, or no segment.
    [[nodiscard]] bool touches(std::size_t at) const { return (inner[at] == kNoSegment) & (solid[at] != kVoidCell); }
    /// Asks the processor to read early what the window of the next line's cell reads and that of this cell does not.
    void readBelowEarly(std::size_t at) const {
        const std::size_t next = std::min(at + (kPlaneReach + 1) * beams_, inner.size() - kPlaneColumns);
        for (const std::size_t k : {next - kPlaneReach, next + kPlaneReach}) {
            __builtin_prefetch(&inner[k]);
            __builtin_prefetch(&u[k]);
        }
        __builtin_prefetch(&solid[at + 2 * beams_]);
    }
    void assign(int line, int beam, std::uint32_t to) { solid[index(line, beam)] = to; }
    /// After a cell and perhaps its neighbours got other segments: `inner` of the cell and its neighbours. Calls say(line, beam, before,
    /// after) for each one that changed.
    template <class Say>
    void renew(int line, int beam, const Say& say) {
        for (int i = std::max(line - 1, 0); i <= std::min(line + 1, lines_ - 1); ++i) {
            for (int j = std::max(beam - 1, 0); j <= std::min(beam + 1, gridBeams_ - 1); ++j) {
                const std::size_t at = index(i, j);
                const std::uint32_t before = inner[at], after = innerSegment(&solid[at], beams_);
                inner[at] = after;
                if (before != after) say(i, j, before, after);
            }
        }
    }

    std::vector<std::uint32_t> solid; ///< the segment, or kVoidCell
    std::vector<std::uint32_t> inner; ///< the segment of cells that do not touch another one, otherwise kNoSegment
    std::vector<float> u;             ///< 1/m

private:
    int lines_, gridBeams_;
    std::size_t beams_;
};

} // namespace edgescan::rocks
