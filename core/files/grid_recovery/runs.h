// A list in order is a row of runs: the returns of one scan line after the other. Where the mirror starts over a new line begins, wherever
// the motor is.
#pragma once

#include "core/files/grid_recovery/return_angles.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace edgescan::files::recognition {

/// Returns `from` to `to` - 1 of the list: one scan line.
struct Run {
    std::size_t from = 0, to = 0;
    double plane = 0.0;      ///< of the half plane in which tilts count positive, radians
    double planeError = 0.0; ///< pi where no return shows it
};

struct Runs {
    std::vector<Run> runs;
    double beamStep = 0.0; ///< usual step of the tilt from return to return, radians
};

/// Empty for a list that does not run along its lines.
[[nodiscard]] std::optional<Runs> runsOf(std::span<const ReturnAngles> returns);

/// Tilt of a return on a line, -pi to pi; where the return may be on either side of the axis, the one nearer to `near`.
[[nodiscard]] double tiltOn(double plane, const ReturnAngles& angles, double near);

} // namespace edgescan::files::recognition
