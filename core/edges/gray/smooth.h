// Gaussian smoothing of the gray image: OpenCV's, or one that ignores missing cells.
#pragma once

#include "core/base/grid.h"
#include "core/edges/gray/gray_loops.h"
#include "core/edges/settings/settings.h"

#include <cstdint>
#include <vector>

namespace edgescan::edges {

/// OpenCV's fixed-point Gaussian of `size` cells: weights in 1/256 that add up to 256 (cv::GaussianBlur on 8-bit images).
/// Sigma NaN: 0.3 ((size - 1) / 2 - 1) + 0.8.
[[nodiscard]] std::vector<int> gaussianWeights(int size, double sigma);

/// cv::GaussianBlur of the gray levels, lines x beams, borders reflected (BORDER_REFLECT_101).
[[nodiscard]] Grid<std::uint8_t> smooth(const Grid<std::uint8_t>& gray, const Settings& settings);

/// The same, by the loops of one instruction set.
[[nodiscard]] Grid<std::uint8_t> smoothBy(InstructionSet set, const Grid<std::uint8_t>& gray, const Settings& settings);

/// As smooth(), but a missing cell in the window counts as the window's centre, and missing cells stay 0: values are not smoothed across
/// the border of a hole. Bit-identical to smooth() if no cell is missing. `missing`: 255 = no valid range.
[[nodiscard]] Grid<std::uint8_t> smoothAroundHoles(const Grid<std::uint8_t>& gray, const Grid<std::uint8_t>& missing,
                                                   const Settings& settings);

} // namespace edgescan::edges
