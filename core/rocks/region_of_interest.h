// Which regions lie mostly outside the region of interest.
#pragma once

#include "core/rocks/rock_map.h"

namespace edgescan {

/// Marks regions with more measured cells outside than inside; nothing happens where the settings name no region.
void markOutside(const RockLeaves& leaves, RockMap& map);

/// Whether a cell lies in the region; true everywhere where there is none.
[[nodiscard]] bool isInside(const std::vector<RegionCorner>& region, int line, int beam);

} // namespace edgescan
