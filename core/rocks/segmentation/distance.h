// Distances between cells of a grid.
#pragma once

#include "core/base/grid.h"

#include <cstdint>

namespace edgescan::rocks {

/// Distance of each cell to the nearest one that is 0 in `free`, in cells; exact. The same for any number of threads (0: as many as make it
/// faster). Without such a cell: the root of 1e15.
[[nodiscard]] Grid<float> distanceToZero(const Grid<std::uint8_t>& free, int threads = 0);

} // namespace edgescan::rocks
