// The simple way from edges to rocks, to compare with: distance to the edges, watershed, and pieces joined where no edge parts them.
#pragma once

#include "core/base/grid.h"

#include <cstdint>

namespace edgescan {

/// Lines x beams: the piece of each cell, from 1; 0 where `solid` is 0. `edges`: 255 = edge. Basins of the distance to the nearest edge or
/// gap are flooded from their peaks; a basin whose peak lies less than a cell above its saddle joins the other, and so do two whose border
/// runs along edges for less than half its length.
[[nodiscard]] Grid<std::uint32_t> watershedRocks(const Grid<std::uint8_t>& edges, const Grid<std::uint8_t>& solid);

} // namespace edgescan
