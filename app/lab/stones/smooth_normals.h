// Normals of what is scanned, smoothed over a few cells of one body.
#pragma once

#include "core/base/grid.h"

#include <Eigen/Core>

#include <cstdint>

namespace edgescan::lab {

/// What the centre ray of each cell hits.
struct TrueCells {
    Grid<std::uint32_t> body;     ///< 0: nothing
    Grid<Eigen::Vector3d> pointM; ///< scanner frame
    double cellRad = 0;           ///< angle between cells
    int finer = 1;                ///< 2 in a grid of half the usual steps: then distances in cells are twice as many
};

/// The plane through the points of the same body within two cells (twice as many in a finer grid), towards the scanner; zero where fewer
/// than six points lie there.
[[nodiscard]] Grid<Eigen::Vector3f> smoothNormals(const TrueCells& cells, int threads);

} // namespace edgescan::lab
