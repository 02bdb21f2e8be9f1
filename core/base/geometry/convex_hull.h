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

/// Corners of the body that the planes normal . x = distance enclose, each given as normal / distance: the origin lies inside.
[[nodiscard]] std::vector<Eigen::Vector3d> cornersBetween(const std::vector<Eigen::Vector3d>& planes);

/// Distinct planes (unit outward normal, offset) of the hull: triangles of one flat face share theirs.
[[nodiscard]] std::vector<Eigen::Vector4d> planesOf(const std::vector<Eigen::Vector3d>& points, const std::vector<HullTriangle>& hull);

} // namespace edgescan::sim
