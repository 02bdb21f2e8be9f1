// Outlines of rocks in the picture.
#pragma once

#include "core/base/grid.h"

#include <cstdint>
#include <vector>

namespace edgescan {

/// A corner of cells: that of cell (line, beam) at its first line and first beam. From 0 to lines, and to beams.
struct CellCorner {
    int line = 0;
    int beam = 0;
    bool operator==(const CellCorner&) const = default;
};

/// A closed way along the sides of cells; the first corner is not repeated.
struct OutlineRing {
    std::vector<CellCorner> corners;   ///< where it turns; x = beam, y = line: outer rings turn counter-clockwise, holes clockwise
    std::vector<std::uint32_t> inside; ///< cells of the rock along it, one after the other
    bool hole = false;
    std::uint32_t part = 0; ///< number of the part of the rock (4 neighbours) that it belongs to, from 0
};

/// By label, from 0 (which is left empty) to `most`: all rings, each part's outer one before its holes.
[[nodiscard]] std::vector<std::vector<OutlineRing>> outlinesOf(const Grid<std::uint32_t>& labels, std::uint32_t most);

} // namespace edgescan
