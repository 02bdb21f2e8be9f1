// Canny on the logarithm of the range: a step counts in percent of its range, and values are not rounded to 8 bits (docs/method/edges.md,
// "Canny on log range").
#pragma once

#include "core/edges/gray/gradient.h"
#include "core/scan/grid/scan.h"

namespace edgescan::edges {

/// Gradient of ln(range), smoothed with kernel and sigma of the settings, with the aperture of the settings. Isolated cells are dropped,
/// gaps of up to 4 cells are filled linearly in inverse range; a cell that is still missing counts as the window's centre. Whole numbers
/// throughout: the same on every machine.
[[nodiscard]] Gradient logRangeGradient(const Scan& scan, const Settings& settings);

/// The gradient, in these units, of a straight step (parallel to lines or beams) of `percent` of the nearer range.
[[nodiscard]] double logRangeGradientOfStep(double percent, const Settings& settings);

/// The inverse: the straight step, in percent of the nearer range, that has this gradient.
[[nodiscard]] double logRangeStepOfGradient(double gradient, const Settings& settings);

/// 255 = edge, lines x beams; a straight step of settings.stepPercent is a weak edge, one with `ratio` times its gradient a strong one.
/// Filled cells are never edges.
[[nodiscard]] Grid<std::uint8_t> logRangeEdges(const Scan& scan, const Settings& settings);

/// lines x beams: 255 where a cell has no range of its own or is isolated; such a cell is never an edge.
[[nodiscard]] Grid<std::uint8_t> withoutOwnRange(const Scan& scan);

} // namespace edgescan::edges
