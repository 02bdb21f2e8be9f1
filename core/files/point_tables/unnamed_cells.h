// Two columns of whole numbers that no heading names.
#pragma once

#include "core/files/point_tables/point_table.h"

namespace edgescan::files {

/// Whether table.line and table.beam are rows and columns of a grid, as FARO writes them, and no numbers, classes or colours: hardly two
/// points share a pair, every index has several points, and neighbours in the grid are neighbours in space.
[[nodiscard]] bool areCells(const PointTable& table);

} // namespace edgescan::files
