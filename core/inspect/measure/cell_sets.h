// Sets of cells that the user selected: the same cells in both images, in the cloud and in an export.
#pragma once

#include "core/base/grid.h"
#include "core/scan/grid/scan.h"

#include <Eigen/Core>

#include <cstdint>
#include <span>
#include <vector>

namespace edgescan::inspect {

/// Indices k = line * beams + beam, ascending, without duplicates.
using CellSet = std::vector<std::uint32_t>;

/// Cells whose middle is inside a polygon, by the even-odd rule. Corners are (beam, line); cell (line, beam) has its middle at (beam + 0.5,
/// line + 0.5). Parts of the polygon outside the grid are cut off.
[[nodiscard]] CellSet cellsInside(int lines, int beams, std::span<const Eigen::Vector2d> corners);

/// The edge cells connected with cell `k` (8 neighbours), including itself; empty if `k` is not an edge. `mask`: not 0 = edge.
[[nodiscard]] CellSet chainAt(const Grid<std::uint8_t>& mask, std::uint32_t k);

[[nodiscard]] CellSet united(const CellSet& a, const CellSet& b);
[[nodiscard]] CellSet without(const CellSet& a, const CellSet& b);
/// All of `cells` cells that are not in `set`.
[[nodiscard]] CellSet allBut(const CellSet& set, std::size_t cells);

/// Cells with a range below `nearM` or above `farM`, metres.
[[nodiscard]] CellSet cellsBeyond(const Scan& scan, double nearM, double farM);
/// Cells with a range outside the smallest box, along the axes of the scan's frame, that contains the points of `set`. Empty if all cells
/// of `set` have no range.
[[nodiscard]] CellSet cellsOutsideBoxOf(const Scan& scan, const CellSet& set);

/// The same set as pairs of first cell and number of consecutive cells, as records store it.
struct CellRun {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
    bool operator==(const CellRun&) const = default;
};
[[nodiscard]] std::vector<CellRun> runsOf(const CellSet& set);
/// Empty runs, runs out of order, and runs beyond `cells` give the empty set.
[[nodiscard]] CellSet cellsOf(std::span<const CellRun> runs, std::size_t cells);

} // namespace edgescan::inspect
