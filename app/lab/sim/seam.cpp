// Computes seams between rays.
#include "app/lab/sim/seam.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace edgescan::sim {
namespace {

constexpr std::size_t kParts = 8; // parts of the path between two rays

// Range at which another ray meets the tangent plane, mm; negative or infinite if it does not.
double metAlong(const TangentPlane& plane, const Eigen::Vector3d& ray) {
    return plane.rangeMm * plane.normal.dot(plane.ray) / plane.normal.dot(ray);
}

double tearMm(const TangentPlane& a, const TangentPlane& b) {
    // Distance of b's surface behind a's on either ray. If both have the same sign, the planes do not meet between the rays.
    const double atA = metAlong(b, a.ray) - a.rangeMm;
    const double atB = b.rangeMm - metAlong(a, b.ray);
    if (!(atA * atB > 0) || !std::isfinite(atA) || !std::isfinite(atB)) return 0.0;
    return std::min(std::abs(atA), std::abs(atB));
}

double foldDeg(const TangentPlane& a, const TangentPlane& b) {
    return std::acos(std::clamp(a.normal.dot(b.normal), -1.0, 1.0)) * 180.0 / std::numbers::pi;
}

// By how much the steepest quarter of the path rises more than the other three quarters do on average, mm.
float riseOfAQuarter(const std::array<TangentPlane, kParts + 1>& way) {
    const double total = std::abs(way.back().rangeMm - way.front().rangeMm);
    double steepest = 0;
    for (std::size_t n = 0; n + kParts / 4 < way.size(); ++n)
        steepest = std::max(steepest, std::abs(way[n + kParts / 4].rangeMm - way[n].rangeMm));
    return static_cast<float>(std::max(0.0, steepest - std::max(0.0, total - steepest) / 3.0));
}

} // namespace

Seam seamBetween(const TangentPlane& a, const TangentPlane& b) {
    return {static_cast<float>(tearMm(a, b)), static_cast<float>(foldDeg(a, b))};
}

Seam seamOnMesh(const TangentPlane& a, const TangentPlane& b, const TangentCast& cast) {
    const Seam whole = seamBetween(a, b);
    if (whole.tearMm <= kLeastTearMm && whole.foldDeg <= kLeastFoldDeg) return whole;
    std::array<TangentPlane, kParts + 1> way;
    way.front() = a;
    way.back() = b;
    float sharpest = 0;
    for (std::size_t n = 1; n <= kParts; ++n) {
        if (n < kParts) {
            const double share = static_cast<double>(n) / kParts;
            const std::optional<TangentPlane> plane = cast((a.ray + share * (b.ray - a.ray)).normalized());
            if (!plane) return whole;
            way[n] = *plane;
        }
        sharpest = std::max(sharpest, seamBetween(way[n - 1], way[n]).foldDeg);
    }
    return {std::min(whole.tearMm, riseOfAQuarter(way)), std::min(whole.foldDeg, sharpest)};
}

} // namespace edgescan::sim
