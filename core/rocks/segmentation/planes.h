// Planes through the cells of one segment around a cell (docs/method/rocks.md, "Step 6").
#pragma once

#include "core/rocks/segmentation/lanes.h"

#include <cstddef>
#include <cstdint>

namespace edgescan::rocks {

/// Number of cells on each side that a plane is fitted to.
inline constexpr int kPlaneReach = 4;
/// Number of cells of a line that are read, beginning kPlaneReach before the middle cell: the width of a window, rounded up to whole
/// vectors.
inline constexpr std::size_t kPlaneColumns = 16;
/// Below this number of cells the plane is their mean.
inline constexpr int kFewestForPlane = 6;
/// Added to the spreads, so that few cells in one line do not tilt the plane.
inline constexpr double kPlaneRidge = 0.5;

/// Sums over the windows of several cells, for planes u = a + b x + c y with x and y in cells from the middle cell.
struct WindowSums {
    /// Number of cells, sum of their rows and of the squares of their rows, each counted from 0, in one number; the same times the column;
    /// numbers of cells times the square of the column.
    Lanes<std::uint32_t> counts, byColumn, bySquare;
    Lanes<double> u, xu, upward; ///< upward: sum of u times the rows up to the end of the window
    Lanes<double> uu;            ///< only from addSquaredWindow()
};

/// Sums over the cells of the window whose `segment` is `own`, for one lane. `segment` and `u` (1/m): the first cells of the window in two
/// grids with `beams` cells per line.
void addWindow(const std::uint32_t* segment, const float* u, std::size_t beams, std::uint32_t own, WindowSums& sums, std::size_t lane);
/// The same, with the sum of the squares of `u`.
void addSquaredWindow(const std::uint32_t* segment, const float* u, std::size_t beams, std::uint32_t own, WindowSums& sums,
                      std::size_t lane);

inline constexpr std::uint32_t kRowsFrom = 11, kSquaresFrom = 21; ///< bits of WindowSums::counts
inline constexpr std::uint32_t kNumberBits = (1U << kRowsFrom) - 1, kRowBits = (1U << (kSquaresFrom - kRowsFrom)) - 1;

/// The sums of one lane, all but u, xu, yu whole numbers.
struct PlaneSums {
    double n, x, y, xx, xy, yy, u, xu, yu;

    EDGESCAN_INLINE PlaneSums(const WindowSums& sums, std::size_t lane) {
        const auto count = static_cast<int>(sums.counts[lane] & kNumberBits);
        const auto rows = static_cast<int>(sums.counts[lane] >> kRowsFrom & kRowBits);
        const auto columns = static_cast<int>(sums.byColumn[lane] & kNumberBits);
        const int corner = count * kPlaneReach * kPlaneReach;
        n = count;
        x = columns - count * kPlaneReach;
        y = rows - count * kPlaneReach;
        xx = static_cast<int>(sums.bySquare[lane]) - 2 * kPlaneReach * columns + corner;
        xy = static_cast<int>(sums.byColumn[lane] >> kRowsFrom) - kPlaneReach * (columns + rows) + corner;
        yy = static_cast<int>(sums.counts[lane] >> kSquaresFrom) - 2 * kPlaneReach * rows + corner;
        u = sums.u[lane];
        xu = sums.xu[lane];
        yu = (kPlaneReach + 1) * sums.u[lane] - sums.upward[lane];
    }
    /// Height of the plane at the middle cell, 1/m; of few cells the mean. Any number without cells.
    EDGESCAN_INLINE double height() const {
        const double a = xx + kPlaneRidge;
        const double d = yy + kPlaneRidge;
        const double minor = a * d - xy * xy;
        const double cx = x * d - y * xy;
        const double cy = y * a - x * xy;
        const double determinant = n * minor - x * cx - y * cy;
        const double fitted = (u * minor - xu * cx - yu * cy) / determinant, mean = u / n;
        return n < kFewestForPlane ? mean : fitted;
    }
};

} // namespace edgescan::rocks
