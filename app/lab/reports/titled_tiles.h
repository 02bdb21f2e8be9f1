// A sheet of several pictures, each with text above it (thesis, chapter 6.1), and with marked cells whose kinds a legend names.
#pragma once

#include "core/base/grid.h"
#include "core/containers/png/png.h"

#include <cstdint>
#include <string>
#include <vector>

namespace edgescan::exports {

/// The shape of a marked cell, so that colour is not its only distinction; visible from 3 pixels per cell on, below that all are squares.
enum class MarkShape : std::uint8_t { Square, Ring, Cross, Plus, Slash };

/// One kind of marked cell.
struct SheetMark {
    std::string name; ///< ASCII, for the legend
    Rgb colour;
    MarkShape shape = MarkShape::Square;
};

struct SheetTile {
    Grid<std::uint8_t> picture; ///< gray levels, drawn bright if cells are marked
    Grid<std::uint8_t> marks;   ///< same shape: 0, or 1 + the legend index of the cell's kind; empty = no marked cells
    std::string title;          ///< ASCII
    std::string line;           ///< second line, ASCII; may be empty
};

struct SheetLook {
    int columns = 1;
    int tilePixels = 460; ///< width of every tile; the height follows from the shape of the first, up to four times the width
    std::string title;    ///< ASCII
    std::vector<SheetMark> legend;
};

/// If a tile has fewer pixels than cells, a marked cell covers an unmarked one, and a later kind of the legend covers an earlier one. Empty
/// without tiles.
[[nodiscard]] Grid<Rgb> contactSheet(const std::vector<SheetTile>& tiles, const SheetLook& look);

} // namespace edgescan::exports
