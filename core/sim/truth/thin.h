// Thins edges to lines one cell wide.
#pragma once

#include "core/base/grid.h"

#include <cstdint>

namespace edgescan {

/// Guo and Hall (1989), "Parallel thinning with two-subiteration algorithms": 255 = edge in and out; what hangs together stays together,
/// and nothing vanishes.
[[nodiscard]] Grid<std::uint8_t> thinned(Grid<std::uint8_t> mask);

} // namespace edgescan
