// Returns as angles about the rotation axis, each with the largest error that rounding gives it; groups of such angles; and angles in their
// order brought to places of which each takes one.
#pragma once

#include "core/files/grid_recovery/parts.h"
#include "core/files/grid_recovery/rings.h"

#include <cstdint>
#include <span>
#include <vector>

namespace edgescan::files::recognition {

/// One return. Radians; the errors are bounds, not deviations.
struct ReturnAngles {
    std::uint32_t point = 0; ///< index into the list
    double plane = 0.0;      ///< atan2 about the axis, whole turn
    double tilt = 0.0;       ///< from the axis, 0 to pi: the side of the axis is unknown
    double planeError = 0.0; ///< pi where the point may be on the axis
    double tiltError = 0.0;
};

[[nodiscard]] std::vector<ReturnAngles> returnsOf(std::span<const AxisPoint> points, const Precision& precision);

/// An angle and the bound of its error.
struct Angle {
    double value = 0.0, error = 0.0;
};

/// Groups of angles on a circle of `period`: from the more precise ones first, as many as it takes until voids show, and then from all that
/// are precise enough for these voids. The clearest first; no more than a few.
[[nodiscard]] std::vector<Ring> ringsAmong(std::span<const Angle> angles, double period);

/// The angles whose errors are below a sixth of the steps of a ring, put into groups again.
[[nodiscard]] std::vector<Ring> ringsOfStep(std::span<const Angle> angles, double period, double step);

/// Brings n values, ascending, to different places 0 .. places - 1 in their order, each near `wanted` (in places): least weighted squares.
/// n is at most `places`.
[[nodiscard]] std::vector<std::size_t> spreadInOrder(std::span<const double> wanted, std::span<const double> weights, std::size_t places);

/// The place of an angle among ascending centres, in places: 2.5 is midway between the third and the fourth. Beyond the ends at their
/// steps.
[[nodiscard]] double placeAmong(const std::vector<double>& centres, double angle);

} // namespace edgescan::files::recognition
