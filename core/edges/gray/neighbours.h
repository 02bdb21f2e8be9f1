// The eight cells around each cell, as every 3 x 3 detector reads them: borders repeated, missing cells counted as the centre.
#pragma once

#include "core/base/grid.h"
#include "core/scan/grid/missing_cells.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace edgescan::edges {

/// Levels of a cell and of its neighbours, clockwise from the top left: 0 1 2 / 7 c 3 / 6 5 4.
struct Neighbours {
    int centre = 0;
    std::array<int, 8> around{};
};

/// The neighbours of one cell. `missing` (255 = no valid range) may be null.
[[nodiscard]] inline Neighbours neighboursAt(const Grid<std::uint8_t>& levels, const Grid<std::uint8_t>* missing, int i, int j) {
    const std::array<int, 3> lines{std::max(i - 1, 0), i, std::min(i + 1, levels.lines - 1)};
    const int left = std::max(j - 1, 0);
    const int right = std::min(j + 1, levels.beams - 1);
    const std::array<std::size_t, 8> cells{levels.index(lines[0], left), levels.index(lines[0], j),     levels.index(lines[0], right),
                                           levels.index(i, right),       levels.index(lines[2], right), levels.index(lines[2], j),
                                           levels.index(lines[2], left), levels.index(i, left)};
    Neighbours at;
    at.centre = levels.at(i, j);
    for (std::size_t n = 0; n < cells.size(); ++n)
        at.around[n] = missing != nullptr && (*missing)[cells[n]] != 0 ? at.centre : levels[cells[n]];
    return at;
}

/// The response `formula(Neighbours)` of every cell, lines x beams; 0 where the cell itself is missing. `missing` (255 = no valid range)
/// may be null.
template <class Formula>
[[nodiscard]] Grid<float> responseOfNeighbours(const Grid<std::uint8_t>& levels, const Grid<std::uint8_t>* missing, Formula formula) {
    Grid<float> response(levels.lines, levels.beams);
    const Grid<std::uint8_t> near = missing != nullptr ? nearMissing(*missing, 1) : Grid<std::uint8_t>();
    for (int i = 0; i < levels.lines; ++i) {
        for (int j = 0; j < levels.beams; ++j) {
            const std::size_t k = levels.index(i, j);
            if (missing != nullptr && (*missing)[k] != 0) continue;
            response[k] = formula(neighboursAt(levels, missing != nullptr && near[k] != 0 ? missing : nullptr, i, j));
        }
    }
    return response;
}

} // namespace edgescan::edges
