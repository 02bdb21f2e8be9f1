// The cells that take no part in the gray methods.
#pragma once

#include "core/edges/settings/settings.h"
#include "core/scan/grid/scan.h"

namespace edgescan {

/// 255 where a cell takes no part in the gray methods under these settings; empty (0 x 0) when all take part.
[[nodiscard]] Grid<std::uint8_t> maskedCells(const Scan& scan, const Settings& settings);

} // namespace edgescan
