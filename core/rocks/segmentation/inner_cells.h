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

/// The segment of each cell of a line. kNoSegment where there is no range, or where one of the 8 neighbours has a range and belongs to
/// another segment or to no segment. `solid`: `step` cells per line.
EDGESCAN_INLINE void markInner(const std::uint32_t* solid, std::size_t step, std::size_t beams, std::uint32_t* __restrict inner) {
    const std::uint32_t* const above = solid - step;
    const std::uint32_t* const below = solid + step;
    for (std::size_t j = 0; j < beams; ++j) {
        const std::uint32_t here = solid[j];
        std::uint32_t others = here == kVoidCell ? 1U : 0U;
        for (const std::uint32_t there :
             {above[j - 1], above[j], above[j + 1], solid[j - 1], solid[j + 1], below[j - 1], below[j], below[j + 1]})
            others |= (there != here ? 1U : 0U) & (there != kVoidCell ? 1U : 0U);
        inner[j] = others != 0 ? kNoSegment : here;
    }
}

/// The segments of a grid with kPlaneReach more cells on each side, and a few more behind them.
class InnerCells {
public:
    InnerCells(const InverseRange& inverse, const Grid<std::uint32_t>& segment);

    /// Cells of a line with its margin.
    [[nodiscard]] std::size_t beams() const { return beams_; }
    [[nodiscard]] std::size_t index(int line, int beam) const {
        return static_cast<std::size_t>(line + kPlaneReach) * beams_ + static_cast<std::size_t>(beam + kPlaneReach);
    }
    void assign(int line, int beam, std::uint32_t to) { solid[index(line, beam)] = to; }
    /// After a cell and perhaps its neighbours got other segments: `inner` of the cell and its neighbours. Calls say(line, beam, before,
    /// after) for each one that changed.
    template <class Say>
    void renew(int line, int beam, const Say& say) {
        for (int i = std::max(line - 1, 0); i <= std::min(line + 1, lines_ - 1); ++i) {
            for (int j = std::max(beam - 1, 0); j <= std::min(beam + 1, gridBeams_ - 1); ++j) {
                const std::size_t at = index(i, j);
                const std::uint32_t before = inner[at], after = innerAt(at);
                inner[at] = after;
                if (before != after) say(i, j, before, after);
            }
        }
    }

    std::vector<std::uint32_t> solid; ///< the segment, or kVoidCell
    std::vector<std::uint32_t> inner; ///< the segment of cells that do not touch another one, otherwise kNoSegment
    std::vector<float> u;             ///< 1/m

private:
    [[nodiscard]] std::uint32_t innerAt(std::size_t at) const;

    int lines_, gridBeams_;
    std::size_t beams_;
};

} // namespace edgescan::rocks
