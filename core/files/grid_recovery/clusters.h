// Cells for points that rounding leaves on several: near the rotation axis all lines meet, near the scanner the beams do.
#pragma once

#include "core/files/grid_recovery/seen.h"

#include <cstdint>
#include <span>
#include <vector>

namespace edgescan::files::recognition {

/// A return and its place on a grid.
struct OnCell {
    std::uint32_t point = 0;
    double range = 0.0;
    double line = 0.0, beam = 0.0;           ///< in lines and beams
    double lineError = 0.0, beamError = 0.0; ///< the same; bounds
    bool turnsOver = false;                  ///< may lie on the other side of the axis just as well:
    double turnedLine = 0.0, turnedBeam = 0.0;
};

/// What became of the points.
struct Placed {
    std::size_t unplaced = 0; ///< no cell within the error was free
    std::size_t doubled = 0;  ///< different points in one cell
    std::size_t copied = 0;   ///< the same point again
};

/// Gives each point a cell of `pointOf`: sure ones theirs, where the nearer of two stays; all others, in the order of their angles, cells
/// that remain free within their errors. `points` serves to find equal points.
Placed placeOnCells(std::span<const OnCell> returns, std::span<const AxisPoint> points, Grid<std::uint32_t>& pointOf);

} // namespace edgescan::files::recognition
