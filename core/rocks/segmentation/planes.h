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

/// A plane through cells around a cell, with the scatter of the cells.
struct FittedPlane {
    int n = 0;
    double u = 0, x = 0, y = 0; ///< height at the middle cell, 1/m, and slopes per cell; of few cells the mean
    double scatter = 0;         ///< root of the mean square distance, 1/m
};

/// Sums over the cells of the window whose `segment` is `own`. `segment` and `u` (1/m): the first cells of the window in two grids with
/// `beams` cells per line.
[[nodiscard]] PlaneSums planeSums(const std::uint32_t* segment, const float* u, std::size_t beams, std::uint32_t own);
/// The plane of the same cells.
[[nodiscard]] FittedPlane fittedPlane(const std::uint32_t* segment, const float* u, std::size_t beams, std::uint32_t own);

} // namespace edgescan::rocks
