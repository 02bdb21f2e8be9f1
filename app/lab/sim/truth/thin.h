// Thins edges to lines one cell wide.
#pragma once

#include "core/base/grid.h"

#include <cstdint>

namespace edgescan::sim {

/// Guo and Hall (1989), "Parallel thinning with two-subiteration algorithms": 255 = edge in input and output; connected cells stay
/// connected, and no component disappears.
[[nodiscard]] Grid<std::uint8_t> thinned(Grid<std::uint8_t> mask);

} // namespace edgescan::sim
