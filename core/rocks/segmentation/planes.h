// Planes through the cells of one leaf around a cell (docs/rocks-method.md, "Step 6").
#pragma once

#include <cstddef>
#include <cstdint>

namespace edgescan {

/// Cells on each side that a plane is fitted to.
inline constexpr int kPlaneReach = 4;
/// Cells of a line that are read, beginning kPlaneReach before the one in the middle: a window, filled up to whole vectors.
inline constexpr std::size_t kPlaneColumns = 12;

/// Sums for the plane u = a + b x + c y, x and y in cells from the one in the middle.
struct PlaneSums {
    int n = 0;
    int x = 0, y = 0, xx = 0, xy = 0, yy = 0;
    double u = 0, xu = 0, yu = 0;

    /// 1/m, of the plane in the middle; of few cells the mean. `n` is not 0.
    [[nodiscard]] double height() const;
};

/// Sums over the cells of the window whose `leaf` is `own`. `leaf` and `u` (1/m): the first cells of the window in two grids with `beams`
/// cells a line.
[[nodiscard]] PlaneSums planeSums(const std::uint32_t* leaf, const float* u, std::size_t beams, std::uint32_t own);

} // namespace edgescan
