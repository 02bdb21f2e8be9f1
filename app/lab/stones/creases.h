// Creases: corners of a body, where its smoothed normal turns within a few cells.
#pragma once

#include "app/lab/stones/smooth_normals.h"

namespace edgescan::lab {

struct Creases {
    Grid<std::uint8_t> sharp; ///< 1: the normal turns by more than 35 degrees, in lines of six cells and more
    Grid<std::uint8_t> weak;  ///< 1: by more than 26 degrees
};

/// @param blocked 1 next to a jump, to another body or to the open: no crease is found there
[[nodiscard]] Creases creasesOf(const TrueCells& cells, const Grid<Eigen::Vector3f>& normals, const Grid<std::uint8_t>& blocked);

/// Cells up to `reach` steps to a neighbouring line or beam from a marked one.
[[nodiscard]] Grid<std::uint8_t> grown(Grid<std::uint8_t> mask, int reach);

} // namespace edgescan::lab
