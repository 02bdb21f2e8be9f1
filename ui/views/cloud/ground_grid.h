// A grid on the level of the lowest points: what is level, and how far things are apart.
#pragma once

#include "ui/views/cloud/cloud_geometry.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace edgescan::ui {

/// Local metres of a cloud.
struct GroundGrid {
    double stepM = 0.0; ///< from line to line: 1, 2 or 5 times a power of ten; 0: there is no grid
    std::vector<std::array<Eigen::Vector3f, 2>> lines;
};

/// At right angles to `up` of CloudGeometry::axes, below all but one in a hundred of the points, as wide as the cloud is. About ten lines
/// each way.
[[nodiscard]] GroundGrid groundOf(const CloudGeometry& cloud);

/// 1, 2 or 5 times a power of ten: the largest that is not above `most`, which is above 0.
[[nodiscard]] double roundedDown(double most);

} // namespace edgescan::ui
