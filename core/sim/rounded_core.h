// Worn rock: a convex body with its corners and ridges rounded off.
#pragma once

#include "core/base/geometry/convex_hull.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace edgescan::sim {

/// The body is all that lies within `radiusM` of the core: flat where the core is, cylinders along its ridges, spheres at its corners.
struct RoundedCore {
    std::vector<Eigen::Vector3d> corners;
    std::vector<HullTriangle> hull;         ///< over the corners
    std::vector<std::array<int, 2>> ridges; ///< corners at both ends; none where the radius is 0
    double radiusM = 0.0;
    double volumeM3 = 0.0; ///< of the rounded body
};

/// Moves every side of the hull in by the radius, and rounds the rest off (an opening by a ball). Flat sides stay where they were, as far
/// as anything is left of them.
/// @param share the radius as a share of the largest ball round the corners' mean that fits in; 0 leaves all as it is. Below 1.
[[nodiscard]] RoundedCore roundedCore(const std::vector<Eigen::Vector3d>& corners, const std::vector<HullTriangle>& hull, double share);

} // namespace edgescan::sim
