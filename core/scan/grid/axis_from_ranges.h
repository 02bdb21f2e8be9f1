// The axis about which a stepper turned the scanner, from the ranges alone (docs/reference/recordings.md, "Axis from the ranges").
#pragma once

#include "core/scan/grid/scan.h"

#include <optional>
#include <vector>

namespace edgescan {

/// The beam along the axis measures the same place in each line: beam 90 degrees of a spin, beams 0 and 180 degrees of a sweep. `rangeMm`
/// and `state`: lines x beams; `beamDeg`: beams, degrees. Empty if the ranges do not show which: too few lines or too short a turn, no
/// return along the axis, or a room that is round about it.
[[nodiscard]] std::optional<Axis> axisFromRanges(const Grid<float>& rangeMm, const Grid<CellState>& state,
                                                 const std::vector<double>& beamDeg);

} // namespace edgescan
