// Canny's edges of the smoothed gray image (thesis 5.5): gradient, non-maximum suppression, hysteresis.
#pragma once

#include "core/base/grid.h"
#include "core/edges/gray/gradient.h"
#include "core/edges/gray/gray_loops.h"
#include "core/edges/settings/settings.h"

#include <cstdint>
#include <vector>

namespace edgescan::edges {

/// 255 = edge, lines x beams: cv::Canny with lower, upper = ratio x lower, aperture and norm of the settings.
[[nodiscard]] Grid<std::uint8_t> canny(const Grid<std::uint8_t>& smoothed, const Settings& settings);

/// The same, by the loops of one instruction set.
[[nodiscard]] Grid<std::uint8_t> cannyBy(InstructionSet set, const Grid<std::uint8_t>& smoothed, const Settings& settings);

/// As canny(), but a missing cell in the gradient window counts as the window's centre and has no gradient itself, so that the border of a
/// hole does not become an edge. Bit-identical to canny() if no cell is missing. `missing`: 255 = no valid range.
[[nodiscard]] Grid<std::uint8_t> cannyAroundHoles(const Grid<std::uint8_t>& smoothed, const Grid<std::uint8_t>& missing,
                                                  const Settings& settings);

/// Suppression and hysteresis of a given gradient; the thresholds are in units of the gradient before its scale.
[[nodiscard]] Grid<std::uint8_t> cannyOfGradient(const Gradient& gradient, double lower, double upper, Norm norm);

/// Indices k = line * beams + beam of the edge cells, ascending.
[[nodiscard]] std::vector<std::uint32_t> edgeCells(const Grid<std::uint8_t>& mask);

} // namespace edgescan::edges
