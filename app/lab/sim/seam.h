// The seam between two rays that end on neighbouring places: a jump in depth, a fold, or neither (docs/method/edges.md, "Truth and score").
#pragma once

#include <Eigen/Core>

#include <functional>
#include <optional>

namespace edgescan::sim {

/// Smaller jumps and folds are not visible as edges.
inline constexpr double kLeastTearMm = 20.0;
inline constexpr double kLeastFoldDeg = 15.0;

/// The end of one ray.
struct TangentPlane {
    Eigen::Vector3d ray;    ///< unit
    double rangeMm = 0.0;   ///< along it
    Eigen::Vector3d normal; ///< unit
};

struct Seam {
    float tearMm = 0;  ///< distance of the two tangent planes on the ray where it is smaller; 0 if they meet between the rays
    float foldDeg = 0; ///< angle between their normals
};

[[nodiscard]] Seam seamBetween(const TangentPlane& a, const TangentPlane& b);

/// The same for two places on one mesh, where facets smaller than the distance between the places do not count as edges. Rays in between
/// decide: the tear is at most the amount by which the steepest quarter of the path exceeds the slope of the rest, and the fold at most the
/// sharpest one between neighbouring rays. If one of these rays ends on another object, `cast` returns nothing and the seam is that between
/// the two places.
using TangentCast = std::function<std::optional<TangentPlane>(const Eigen::Vector3d& ray)>;
[[nodiscard]] Seam seamOnMesh(const TangentPlane& a, const TangentPlane& b, const TangentCast& cast);

} // namespace edgescan::sim
