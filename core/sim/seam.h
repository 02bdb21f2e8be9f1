// What lies between two rays that end beside each other: a jump in depth, a fold, or nothing (docs/method.md, "Truth and score").
#pragma once

#include <Eigen/Core>

#include <functional>
#include <optional>

namespace edgescan::sim {

/// Below these a seam is none: nobody sees it.
inline constexpr double kLeastTearMm = 20.0;
inline constexpr double kLeastFoldDeg = 15.0;

/// Where one ray ended.
struct TangentPlane {
    Eigen::Vector3d ray;    ///< unit
    double rangeMm = 0.0;   ///< along it
    Eigen::Vector3d normal; ///< unit
};

struct Seam {
    float tearMm = 0;  ///< how far the two tangent planes are apart, on the ray where they are closer; 0 where they meet between the rays
    float foldDeg = 0; ///< angle between their normals
};

[[nodiscard]] Seam seamBetween(const TangentPlane& a, const TangentPlane& b);

/// The same for two places on one mesh, whose facets may be smaller than the way between them and no edge of anything. The rays that
/// `cast` tries in between tell: a tear counts for no more than the steepest quarter of the way rises by beyond the slope of the rest, a
/// fold for no more than the sharpest one between neighbouring rays. `cast` gives nothing where a ray ends elsewhere; then the seam is as
/// between the two.
using TangentCast = std::function<std::optional<TangentPlane>(const Eigen::Vector3d& ray)>;
[[nodiscard]] Seam seamOnMesh(const TangentPlane& a, const TangentPlane& b, const TangentCast& cast);

} // namespace edgescan::sim
