// Convex hull of a few points.
#pragma once

#include <Eigen/Core>

#include <array>
#include <vector>

namespace edgescan::sim {

/// Corners as indices into the points, counter-clockwise seen from outside.
using HullTriangle = std::array<int, 3>;

/// Triangles of the hull; empty when the points lie in one plane. For tens of points: the cost grows with their square.
[[nodiscard]] std::vector<HullTriangle> convexHull(const std::vector<Eigen::Vector3d>& points);

} // namespace edgescan::sim
