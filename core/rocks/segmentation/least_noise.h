// The noise of the ranges, without the relief and slant of the surfaces (docs/method/rocks.md, "Inputs").
#pragma once

#include "core/scan/grid/inverse_range.h"

namespace edgescan::rocks {

/// Standard deviation of the ranges at 5 m, mm. Relief and slant only add to the distance of a cell from the line through its neighbours.
/// So the range bin in which this distance is least, compared with how the noise of an LMS511 grows with the range, is nearest to the noise
/// itself. 0 if no bin has enough cells.
[[nodiscard]] double leastNoiseMm(const InverseRange& inverse);

} // namespace edgescan::rocks
