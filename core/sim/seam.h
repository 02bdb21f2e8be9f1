// What lies between two rays that end beside each other: a jump in depth, a fold, or nothing (docs/method.md, "Truth and score").
#pragma once

#include <Eigen/Core>

#include <functional>
#include <optional>

namespace edgescan::sim {

/// Below these nobody sees an edge.
inline constexpr double kLeastTearMm = 20.0;
inline constexpr double kLeastFoldDeg = 15.0;

/// Where one ray ended.
struct TangentPlane {
    Eigen::Vector3d ray;    ///< unit
    double rangeMm = 0.0;   ///< along it
    Eigen::Vector3d normal; ///< unit
};

struct Seam {
    float tearMm = 0;  ///< distance of the two tangent planes, on the ray where it is smaller; 0 where they meet between the rays
    float foldDeg = 0; ///< angle between their normals
};

[[nodiscard]] Seam seamBetween(const TangentPlane& a, const TangentPlane& b);

/// The same for two places on one mesh, where facets smaller than the distance between the places are no edges. Rays in between decide: a
/// tear counts for no more than the steepest quarter of the way rises beyond the slope of the rest, a fold for no more than the sharpest
/// one between neighbouring rays. Where one of these rays ends elsewhere, `cast` gives nothing and the seam is that between the two
/// places.
using TangentCast = std::function<std::optional<TangentPlane>(const Eigen::Vector3d& ray)>;
[[nodiscard]] Seam seamOnMesh(const TangentPlane& a, const TangentPlane& b, const TangentCast& cast);

} // namespace edgescan::sim
