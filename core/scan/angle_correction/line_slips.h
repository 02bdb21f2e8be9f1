// A stepper that slips: lines that were measured at another angle than the one they are said to have (thesis 7.2).
#pragma once

#include "core/scan/grid/inverse_range.h"

#include <array>
#include <vector>

namespace edgescan {

/// By how many index steps the stepper went too far from each line to the next, as even and as odd beams show it; 0 on most lines, and
/// where it cannot be told.
using LineSteps = std::array<std::vector<float>, 2>;

/// -1 is a stall, +2 a leap that makes up for two stalls. Measured as the weighted median over the slanted cells of a line, with slopes
/// taken over many lines, because those beside the slip may have slipped too. The same with any number of threads (0: as many as pay).
[[nodiscard]] LineSteps lineSlips(const InverseRange& inverse, int threads = 0);

/// Brings displaced lines back to the angle they are said to have, on slanted surfaces and never across a jump. Returns what remains of the
/// slips: one longer or shorter step where the stepper did not make up for all of them.
[[nodiscard]] LineSteps bringToLines(InverseRange& inverse, const LineSteps& slips);

} // namespace edgescan
