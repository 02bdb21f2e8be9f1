// Calipers of points in a plane.
#pragma once

#include <Eigen/Core>

#include <vector>

namespace edgescan {

/// Largest and smallest distance of two parallel lines that hold all the points between them; 0 without points.
struct Calipers {
    double longest = 0.0, shortest = 0.0;
};
[[nodiscard]] Calipers calipersOf(const std::vector<Eigen::Vector2d>& points);

} // namespace edgescan
