// Worn rock: a convex body with rounded corners and ridges.
#pragma once

#include "core/base/geometry/convex_hull.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace edgescan::sim {

/// The body contains all points within `radiusM` of the core: flat over the core's sides, cylinders along its ridges, spheres at its
/// corners.
struct RoundedCore {
    std::vector<Eigen::Vector3d> corners;
    std::vector<HullTriangle> hull;         ///< over the corners
    std::vector<std::array<int, 2>> ridges; ///< the corners at both ends; empty if the radius is 0
    double radiusM = 0.0;
    double volumeM3 = 0.0; ///< of the rounded body
};

/// Moves every side of the hull inwards by the radius, and rounds the rest (an opening by a ball). The remaining parts of flat sides keep
/// their place. @param share the radius as a share of the largest ball around the mean of the corners that fits inside; below 1; 0 changes
/// nothing
[[nodiscard]] RoundedCore roundedCore(const std::vector<Eigen::Vector3d>& corners, const std::vector<HullTriangle>& hull, double share);

} // namespace edgescan::sim
