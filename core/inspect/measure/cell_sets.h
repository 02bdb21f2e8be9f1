// Sets of cells that somebody selected: the same cells in both images, in the cloud and in an export.
#pragma once

#include "core/base/grid.h"
#include "core/scan/grid/scan.h"

#include <Eigen/Core>

#include <cstdint>
#include <span>
#include <vector>

namespace edgescan {

/// Indices k = line * beams + beam, ascending, none twice.
using CellSet = std::vector<std::uint32_t>;

/// Cells whose middle lies inside a polygon, by the even-odd rule. Corners as (beam, line); cell (line, beam) has its middle at
/// (beam + 0.5, line + 0.5). A polygon that leaves the grid is cut off there.
[[nodiscard]] CellSet cellsInside(int lines, int beams, std::span<const Eigen::Vector2d> corners);

/// The edge cells that hang together with cell `k` (8 neighbours), itself included; empty where it is none. `mask`: not 0 = edge.
[[nodiscard]] CellSet chainAt(const Grid<std::uint8_t>& mask, std::uint32_t k);

[[nodiscard]] CellSet united(const CellSet& a, const CellSet& b);
[[nodiscard]] CellSet without(const CellSet& a, const CellSet& b);
/// Of `cells` cells all that are not in it.
[[nodiscard]] CellSet allBut(const CellSet& set, std::size_t cells);

/// Cells with a range below `nearM` or above `farM`, metres.
[[nodiscard]] CellSet cellsBeyond(const Scan& scan, double nearM, double farM);
/// Cells with a range that lie outside the smallest box along the axes of the scan's frame which holds those of `set`. Empty where none of
/// these has a range.
[[nodiscard]] CellSet cellsOutsideBoxOf(const Scan& scan, const CellSet& set);

/// The same as pairs of first cell and number of cells that follow each other, as records hold it.
struct CellRun {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
    bool operator==(const CellRun&) const = default;
};
[[nodiscard]] std::vector<CellRun> runsOf(const CellSet& set);
/// Empty runs, runs out of order or beyond `cells` give the empty set.
[[nodiscard]] CellSet cellsOf(std::span<const CellRun> runs, std::size_t cells);

} // namespace edgescan
