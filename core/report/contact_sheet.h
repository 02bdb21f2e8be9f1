// Small pictures side by side, each with its words above it (thesis, chapter 6.1).
#pragma once

#include "core/base/grid.h"

#include <cstdint>
#include <string>
#include <vector>

namespace edgescan {

struct SheetTile {
    Grid<std::uint8_t> picture; ///< gray levels, or 255 = edge
    bool mask = false;          ///< edges keep their brightness when the picture gets smaller
    std::string title;          ///< ASCII
    std::string line;           ///< second line, ASCII; may be empty
};

/// 8-bit gray. `columns` tiles in a row, each `tilePixels` wide; all tiles have the shape of the first.
[[nodiscard]] Grid<std::uint8_t> contactSheet(const std::vector<SheetTile>& tiles, int columns, int tilePixels, const std::string& title);

} // namespace edgescan
