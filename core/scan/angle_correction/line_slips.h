// Finds slips of the stepper: lines that were measured at another angle than the recorded one (thesis 7.2).
#pragma once

#include "core/scan/grid/inverse_range.h"

#include <array>
#include <vector>

namespace edgescan {

/// By how many index steps the stepper went too far from each line to the next, measured on the even and on the odd beams. 0 on most lines,
/// and where it cannot be measured.
using LineSteps = std::array<std::vector<float>, 2>;

/// Measures the slips: -1 is a stall, +2 a leap that makes up for two stalls. A slip is the weighted median over the slanted cells of a
/// line. The slopes are taken over many lines, because the lines next to the slip may have slipped too. The result is the same for any
/// number of threads (0: as many as make it faster).
[[nodiscard]] LineSteps lineSlips(const InverseRange& inverse, int threads = 0);

/// Moves displaced lines back to their recorded angles, on slanted surfaces and never across a jump. Returns the rest of the slips: one
/// longer or shorter step where the stepper did not make up for all of them.
[[nodiscard]] LineSteps moveToRecordedAngles(InverseRange& inverse, const LineSteps& slips);

} // namespace edgescan
