// Finds the regions that are mostly outside the region of interest.
#pragma once

#include "core/rocks/selection/rock_map.h"

namespace edgescan::rocks {

/// Marks regions with more measured cells outside than inside. Does nothing if the settings have no region of interest.
void markOutsideRegion(const Segmentation& segments, RegionMap& map);

/// Whether a cell is inside the region; always true for an empty region.
[[nodiscard]] bool isInside(const std::vector<RegionCorner>& region, int line, int beam);
/// The same for all cells, lines x beams: 1 inside.
[[nodiscard]] Grid<std::uint8_t> insideMask(const std::vector<RegionCorner>& region, int lines, int beams);

/// The polygon of a drawn line, without corners whose removal changes it by less than a cell or two; empty if fewer than three corners
/// remain.
[[nodiscard]] std::vector<RegionCorner> regionOfDrawing(const std::vector<RegionCorner>& drawn);

} // namespace edgescan::rocks
