// Converts a drawn line, or a turn of the wheel, to edits of the rocks there.
#pragma once

#include "core/rocks/selection/edits.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace edgescan::rocks {

/// A line over borders: all regions that it crosses become one rock. See joinOf().
/// Empty if the line crosses fewer than two regions.
[[nodiscard]] std::optional<Edit> joinAlong(const Segmentation& segments, const RegionMap& map, const CutLine& stroke);

/// A line that divides one rock from side to side: the edits make its parts rocks of their own, and no cell of another region changes. A
/// part has kFewestSplit cells or more. Of the rocks that the line divides it is that of the cell `chosen`, else the one with most of the
/// line's cells: a line drawn past an outline crosses small neighbours too. A line that is in no rock cuts the other regions that it
/// crosses. Empty if it divides nothing.
[[nodiscard]] std::vector<Edit> cutAlong(const Segmentation& segments, const RegionMap& map, const CutLine& stroke,
                                         std::optional<std::uint32_t> chosen = {});

/// The pieces that the wheel steps through at a cell: those around it with 50 or more cells, and its region at the current level. Where
/// edits joined the region, the part at the cell as it was before is one of them, and smaller pieces are those of that part.
struct WheelPieces {
    NestedPieces nested;
    /// index of the piece that a click splits off: the joined part, else the piece of splitAt(); that of the region if there is no such
    /// piece
    std::size_t split = 0;
    std::optional<std::vector<Edit>> unjoined{}; ///< all edits, without what joins the part `split` to the others; empty: nothing does
    std::vector<Edit> others{};                  ///< with `unjoined`: the edits that join nothing of the region
};
/// At most `mostLarger` pieces are larger than the region. Without pieces if the cell does not belong to a segment. `edits`: those that the
/// tree was made with.
[[nodiscard]] WheelPieces wheelPiecesAt(const Segmentation& segments, const MergeTree& tree, double level, std::uint32_t k,
                                        std::span<const Edit> edits, std::size_t mostLarger = 8);

/// All edits after the piece with this index is split off a region that edits joined: the piece is one rock, and what is left of the region
/// is another. Empty if no edit joined the region, or for the region and larger pieces: the piece's own edit is added then.
[[nodiscard]] std::optional<std::vector<Edit>> editsOfSplit(const Segmentation& segments, const WheelPieces& wheel, std::size_t piece);

} // namespace edgescan::rocks
