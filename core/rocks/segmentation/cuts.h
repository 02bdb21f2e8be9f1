// Strokes of a person through leaves (docs/rocks-method.md, "Edits").
#pragma once

#include "core/rocks/segmentation/barrier.h"
#include "core/rocks/segmentation/merge_tree.h"

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace edgescan {

/// Cells one after the other, joined by straight lines of cells.
using CutLine = std::vector<std::uint32_t>;

/// All cells of the line, one after the other; corners that do not exist are left out.
[[nodiscard]] std::vector<std::uint32_t> strokeCells(const CutLine& line, int lines, int beams);

/// Cuts each leaf that a line crosses into what lies on its two sides, and numbers all leaves anew by first cells. Cells that do not
/// exist are left out.
void cutLeaves(const CellLinks& links, std::span<const CutLine> cuts, Grid<std::uint32_t>& leaf);

/// Leaves that lie on the two sides of a line, in front of each other: to be kept apart. `leaf`: as cutLeaves() left it.
[[nodiscard]] std::vector<LeafPair> leavesAcross(const Grid<std::uint32_t>& leaf, std::span<const LeafBorder> borders,
                                                 std::span<const CutLine> cuts);

} // namespace edgescan
