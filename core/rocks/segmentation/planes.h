// Planes through the cells of one segment around a cell (docs/method/rocks.md, "Step 6").
#pragma once

#include <cstddef>
#include <cstdint>

namespace edgescan::rocks {

/// Number of cells on each side that a plane is fitted to.
inline constexpr int kPlaneReach = 4;
/// Number of cells of a line that are read, beginning kPlaneReach before the middle cell: the width of a window, rounded up to whole
/// vectors.
inline constexpr std::size_t kPlaneColumns = 12;

/// Sums for the plane u = a + b x + c y, with x and y in cells from the middle cell.
struct PlaneSums {
    int n = 0;
    int x = 0, y = 0, xx = 0, xy = 0, yy = 0;
    double u = 0, xu = 0, yu = 0;

    /// Height of the plane at the middle cell, 1/m; of few cells the mean. `n` must not be 0.
    [[nodiscard]] double height() const;
};

/// Sums over the cells of the window whose `segment` is `own`. `segment` and `u` (1/m): the first cells of the window in two grids with
/// `beams` cells per line.
[[nodiscard]] PlaneSums planeSums(const std::uint32_t* segment, const float* u, std::size_t beams, std::uint32_t own);

} // namespace edgescan::rocks
