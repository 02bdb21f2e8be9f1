// The first segments: basins of the distance to the barriers, with shallow ones joined (docs/method/rocks.md, "Step 3").
#pragma once

#include "core/rocks/segmentation/barrier.h"

#include <cstdint>
#include <span>
#include <vector>

namespace edgescan::rocks {

/// Two basins are joined if their saddle is less than this many cells below the lower of their peaks.
inline constexpr float kShallow = 0.7F;

/// Lines x beams: kOpen where the cell was not measured, otherwise the segment, numbered from 1 by first cells. `distance`: to the barrier,
/// in cells. Each cell moves to its linked neighbour with the largest distance; on a plateau to the one above or to the left.
[[nodiscard]] Grid<std::uint32_t> segmentBasins(const Grid<float>& distance, const CellLinks& links);

/// Numbers the groups of cells by their first cells, from 1; kOpen is unchanged. `group`: any number per cell below lines x beams + 1.
/// `joined`: by number, the group that each group was joined to. Returns the number of groups.
std::uint32_t numberByFirstCell(Grid<std::uint32_t>& group, std::span<const std::uint32_t> joined = {});

/// The largest number of a cell: the number of segments if they are numbered from 1; 0 without cells.
[[nodiscard]] std::uint32_t lastSegment(const Grid<std::uint32_t>& segment);

/// Groups of numbers that are joined step by step (union-find).
class JoinedGroups {
public:
    explicit JoinedGroups(std::size_t count);
    [[nodiscard]] std::uint32_t of(std::uint32_t n);
    /// Adds the group of `from` to that of `into`.
    void join(std::uint32_t into, std::uint32_t from) { parent_[of(from)] = of(into); }

private:
    std::vector<std::uint32_t> parent_;
};

} // namespace edgescan::rocks
