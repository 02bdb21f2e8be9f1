// The axis about which a known grid of lines and beams turns, in whatever frame its points are.
#pragma once

#include "core/base/grid.h"

#include <Eigen/Core>

#include <optional>

namespace edgescan::files {

/// `points`: lines x beams about the sensor, any unit; not finite or (0, 0, 0) = missing. A turn that makes the axis the z axis: all points
/// of a beam have the same angle from it. Empty when too few show it.
[[nodiscard]] std::optional<Eigen::Matrix3d> turnToAxis(const Grid<Eigen::Vector3d>& points);

} // namespace edgescan::files
