// A horizontal grid at the level of the lowest points: shows the horizontal direction and the distances.
#pragma once

#include "ui/views/cloud/cloud_geometry.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace edgescan::ui {

/// In local metres of a cloud.
struct GroundGrid {
    double stepM = 0.0; ///< spacing of the lines: 1, 2 or 5 times a power of ten; 0: no grid
    std::vector<std::array<Eigen::Vector3f, 2>> lines;
};

/// Perpendicular to `up` of CloudGeometry::axes, below 99 % of the points, as wide as the cloud, with about ten lines in each direction.
[[nodiscard]] GroundGrid groundOf(const CloudGeometry& cloud);

/// The largest number of the form 1, 2 or 5 times a power of ten that is at most `most` (> 0).
[[nodiscard]] double roundedDown(double most);

} // namespace edgescan::ui
