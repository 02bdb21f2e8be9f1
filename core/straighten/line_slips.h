// A stepper that slips: lines that were measured at another angle than the one they are said to have (thesis 7.2).
#pragma once

#include "core/scan/inverse_range.h"

#include <array>
#include <vector>

namespace edgescan {

/// By how many index steps the way from a line to the next was longer than it should be, for even and for odd beams; 0 where that cannot be
/// told, and on most lines.
using LineSteps = std::array<std::vector<float>, 2>;

/// A stall is -1, a leap that makes up for two is +2. The robust median over the slanted cells of a line says it, measured by the slope of
/// the surface over many lines: those beside the slip may have slipped, too.
[[nodiscard]] LineSteps lineSlips(const InverseRange& inverse);

/// Brings the cells of lines that lie beside their places to the angle of their line, on slanted surfaces and never across a jump. Returns
/// what is left of the slips: one longer or shorter step where the stepper did not make up for all.
[[nodiscard]] LineSteps bringToLines(InverseRange& inverse, const LineSteps& slips);

} // namespace edgescan
