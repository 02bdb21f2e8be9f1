// Strokes that a person draws through segments (docs/method/rocks.md, "Edits").
#pragma once

#include "core/rocks/segmentation/barrier.h"
#include "core/rocks/segmentation/merge_tree.h"

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace edgescan::rocks {

/// Consecutive cells, connected by straight lines of cells.
using CutLine = std::vector<std::uint32_t>;

/// All cells of the line in order; corners outside of the grid are left out.
[[nodiscard]] std::vector<std::uint32_t> strokeCells(const CutLine& line, int lines, int beams);

/// Cuts each segment that a line crosses into the parts on its two sides, and numbers all segments again by first cells. Cells outside of
/// the grid are left out.
void cutSegments(const CellLinks& links, std::span<const CutLine> cuts, Grid<std::uint32_t>& segment);

/// Pairs of segments on opposite sides of a line that border on each other: they must not be merged. `segment`: as cutSegments() left it.
[[nodiscard]] std::vector<SegmentPair> segmentsAcross(const Grid<std::uint32_t>& segment, std::span<const SegmentBorder> borders,
                                                      std::span<const CutLine> cuts);

} // namespace edgescan::rocks
