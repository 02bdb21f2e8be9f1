// Convex hull of a few points.
#pragma once

#include <Eigen/Core>

#include <array>
#include <vector>

namespace edgescan {

/// The corners as indices of points, counter-clockwise as seen from outside.
using HullTriangle = std::array<int, 3>;

/// Triangles of the hull; empty if all points are in one plane. Meant for tens of points: the cost grows with the square of their number.
[[nodiscard]] std::vector<HullTriangle> convexHull(const std::vector<Eigen::Vector3d>& points);

/// Corners of the body that the planes normal . x = distance enclose. Each plane is given as normal / distance. The origin must be inside
/// the body.
[[nodiscard]] std::vector<Eigen::Vector3d> cornersBetween(const std::vector<Eigen::Vector3d>& planes);

/// The different planes (unit outward normal, offset) of the hull: the triangles of one flat face share a plane.
[[nodiscard]] std::vector<Eigen::Vector4d> planesOf(const std::vector<Eigen::Vector3d>& points, const std::vector<HullTriangle>& hull);

} // namespace edgescan
