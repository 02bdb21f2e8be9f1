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

/// Cuts each segment that the line crosses into the parts on its two sides: the part with the first cell has the number of the segment, the
/// others get new numbers behind `count`. No other cell changes. Returns the number of segments. Cells outside of the grid are left out.
/// `basins`: the same segments before their borders were refined, cut alike; may be null. `cutFrom`: receives the segment of each new
/// number; may be null.
std::uint32_t cutSegments(const CellLinks& links, const CutLine& cut, std::uint32_t count, Grid<std::uint32_t>& segment,
                          Grid<std::uint32_t>* basins = nullptr, std::vector<std::uint32_t>* cutFrom = nullptr);

/// Pairs of segments on opposite sides of a line that border on each other: they must not be merged. `segment`: as cutSegments() left it.
[[nodiscard]] std::vector<SegmentPair> segmentsAcross(const Grid<std::uint32_t>& segment, std::span<const SegmentBorder> borders,
                                                      std::span<const CutLine> cuts);

} // namespace edgescan::rocks
