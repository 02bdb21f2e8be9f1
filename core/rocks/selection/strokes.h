// What a line that a person drew, or a turn of the wheel, says about rocks: edits for the pieces there.
#pragma once

#include "core/rocks/selection/edits.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace edgescan {

/// A line over cracks: all regions that it crosses become one. Each is named by a cell in the middle of its part of the line. Empty where
/// it crosses fewer than two.
[[nodiscard]] std::optional<RockEdit> joinAlong(const RockLeaves& leaves, const RockMap& map, const CutLine& stroke);

/// A line along which pieces are cut. Empty where it lies on no region at all.
[[nodiscard]] std::optional<RockEdit> cutAlong(const RockLeaves& leaves, const RockMap& map, const CutLine& stroke);

/// What the wheel walks through at a cell: the pieces round it of 50 cells and more, and its region at the level.
struct RockFamily {
    RockLine line;
    std::size_t split = 0; ///< place of what splitAt() would split off; that of the region where there is nothing
};
/// At most `mostLarger` pieces are larger than the region. Without pieces where the cell belongs to no leaf.
[[nodiscard]] RockFamily familyAt(const RockLeaves& leaves, const MergeTree& tree, double level, std::uint32_t k,
                                  std::size_t mostLarger = 8);

} // namespace edgescan
