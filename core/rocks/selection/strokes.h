// Converts a drawn line, or a turn of the wheel, to edits of the rocks there.
#pragma once

#include "core/rocks/selection/edits.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace edgescan::rocks {

/// A line over borders: all regions that it crosses become one rock. Each region is given by a cell in the middle of its part of the line.
/// Empty if the line crosses fewer than two regions.
[[nodiscard]] std::optional<Edit> joinAlong(const Segmentation& segments, const RegionMap& map, const CutLine& stroke);

/// A line along which pieces are cut. Empty if the line is outside of all regions.
[[nodiscard]] std::optional<Edit> cutAlong(const Segmentation& segments, const RegionMap& map, const CutLine& stroke);

/// The pieces that the wheel steps through at a cell: those around it with 50 or more cells, and its region at the current level.
struct WheelPieces {
    NestedPieces nested;
    std::size_t split = 0; ///< index of the piece that splitAt() would split off; that of the region if there is no such piece
};
/// At most `mostLarger` pieces are larger than the region. Without pieces if the cell does not belong to a segment.
[[nodiscard]] WheelPieces wheelPiecesAt(const Segmentation& segments, const MergeTree& tree, double level, std::uint32_t k,
                                        std::size_t mostLarger = 8);

} // namespace edgescan::rocks
