// The cells that the gray methods ignore.
#pragma once

#include "core/edges/settings/settings.h"
#include "core/scan/grid/scan.h"

namespace edgescan::edges {

/// lines x beams: 255 where the gray methods ignore a cell under these settings; empty (0 x 0) if they use all cells.
[[nodiscard]] Grid<std::uint8_t> maskedCells(const Scan& scan, const Settings& settings);

} // namespace edgescan::edges
