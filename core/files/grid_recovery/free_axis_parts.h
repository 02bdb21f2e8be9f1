// The parts of the search for a free axis: a first guess from neighbours in the list, then planes of lines, then rays of beams.
#pragma once

#include "core/files/grid_recovery/recover_grid.h"

#include <Eigen/Core>

#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace edgescan::files::turning {

/// Axes of the file -> axes with the third along the rotation axis, about a point of it.
struct AxisFrame {
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    double misfit = 0.0; ///< of half of the planes, from the centre

    [[nodiscard]] Eigen::Vector3d operator()(const Eigen::Vector3d& p) const { return turn * (p - centre); }
};

/// From planes through neighbours in the list. `returns`: returns only, in order; `rounding`: of their coordinates. Empty when half of the
/// planes do not contain one direction and one line.
[[nodiscard]] std::optional<AxisFrame> guessAxis(std::span<const Eigen::Vector3d> returns, double rounding);

/// The place along the axis from which neighbours in the list are one step apart: the centre moves there.
void guessPlaceOnAxis(AxisFrame& frame, std::span<const Eigen::Vector3d> returns);

/// Returns `from` to `to` - 1 of the list, and the angle of their half plane about the axis, radians.
struct ScanLine {
    std::size_t from = 0, to = 0;
    double angle = 0.0;
};

/// The fan on the stepper: q = Rz(angle) Rx(roll) (mirror + r (cos a, 0, sin a)) in the axis frame.
struct FanModel {
    double roll = 0.0;
    Eigen::Vector3d mirror = Eigen::Vector3d::Zero();
    double step = 0.0;   ///< from beam to beam, radians, in the order of the list
    double misfit = 0.0; ///< root mean square distance from the planes, and of even beams from the rays, whichever is more
};

/// Fits axis, centre, roll and mirror.y() to the planes of all lines, and the angle of each line.
void fitPlanes(AxisFrame& frame, std::vector<ScanLine>& lines, FanModel& fan, std::span<const Eigen::Vector3d> returns);

/// A function from a return to the same in its fan: Rx(-roll) Rz(-angle) q.
[[nodiscard]] inline auto intoFan(double angle, double roll) {
    return [c = std::cos(angle), s = std::sin(angle), cr = std::cos(roll), sr = std::sin(roll)](const Eigen::Vector3d& q) {
        const double y = c * q.y() - s * q.x();
        return Eigen::Vector3d(c * q.x() + s * q.y(), cr * y + sr * q.z(), cr * q.z() - sr * y);
    };
}

/// FanBeams of a fan, radians.
struct FanBeams {
    double first = 0.0, last = 0.0;                   ///< of the even ones with points; both 0 when the beams are not even
    Eigen::Vector2d middle = Eigen::Vector2d::Zero(); ///< mean direction of all returns: across and along the axis
};

/// Fits mirror.x() and mirror.z() to the rays of all beams. `inFans`: one per return. Empty when neighbours have no common step.
[[nodiscard]] std::optional<FanBeams> fitRays(FanModel& fan, std::span<const Eigen::Vector3d> inFans, const std::vector<ScanLine>& lines);

} // namespace edgescan::files::turning
