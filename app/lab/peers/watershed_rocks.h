// A simple method that finds rocks from edges, for comparison: distance to the edges, watershed, and joining of pieces that are not
// separated by an edge.
#pragma once

#include "core/base/grid.h"

#include <cstdint>

namespace edgescan::lab {

/// Lines x beams: the piece of each cell, from 1; 0 where `solid` is 0. `edges`: 255 = edge. Basins of the distance to the nearest edge or
/// gap are flooded from their peaks. Two basins are joined if the lower peak is less than a cell above the saddle, or if less than half of
/// their border runs along edges.
[[nodiscard]] Grid<std::uint32_t> watershedRocks(const Grid<std::uint8_t>& edges, const Grid<std::uint8_t>& solid);

} // namespace edgescan::lab
