// Which regions lie mostly outside the region of interest.
#pragma once

#include "core/rocks/selection/rock_map.h"

namespace edgescan {

/// Marks regions with more measured cells outside than inside; nothing happens where the settings name no region.
void markOutside(const RockLeaves& leaves, RockMap& map);

/// Whether a cell lies in the region; true everywhere where there is none.
[[nodiscard]] bool isInside(const std::vector<RegionCorner>& region, int line, int beam);
/// The same of all cells, lines x beams: 1 inside.
[[nodiscard]] Grid<std::uint8_t> insideMask(const std::vector<RegionCorner>& region, int lines, int beams);

/// The polygon round a line that was drawn, without corners that change it by less than a cell or two; empty where fewer than three are
/// left.
[[nodiscard]] std::vector<RegionCorner> regionOfDrawing(const std::vector<RegionCorner>& drawn);

} // namespace edgescan
