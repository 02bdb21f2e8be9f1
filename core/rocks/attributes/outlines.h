// Outlines of rocks in the picture.
#pragma once

#include "core/base/grid.h"

#include <cstdint>
#include <vector>

namespace edgescan::rocks {

/// A corner point of cells: that of cell (line, beam) at its first line and first beam. From 0 to lines, and from 0 to beams.
struct CellCorner {
    int line = 0;
    int beam = 0;
    bool operator==(const CellCorner&) const = default;
};

/// A closed path along the sides of cells; the first corner is not repeated at the end.
struct OutlineRing {
    /// where its direction changes; x = beam, y = line: outer rings are counter-clockwise, holes clockwise
    std::vector<CellCorner> corners;
    std::vector<std::uint32_t> inside; ///< the rock's cells along the ring, in order
    bool hole = false;
    std::uint32_t part = 0; ///< number, from 0, of the connected part of the rock (4 neighbours)
};

/// By label, from 0 (which stays empty) to `most`: all rings; the outer ring of each part precedes its holes.
[[nodiscard]] std::vector<std::vector<OutlineRing>> outlinesOf(const Grid<std::uint32_t>& labels, std::uint32_t most);

} // namespace edgescan::rocks
