// One beam as a bundle of sub-rays over its footprint, and their hits.
#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

namespace edgescan::sim {

inline constexpr std::size_t kSubRays = 11; ///< per beam (docs/method/edges.md, "Simulator")
inline constexpr std::size_t kLanes = 12;   ///< number of sub-rays rounded up to whole vector registers; the last lane repeats the centre

template <class T>
using Lanes = std::array<T, kLanes>;

/// Metres, scanner frame; directions have unit length within the precision of float. Lane 0 is the centre of the beam.
struct RayBundle {
    alignas(16) Lanes<float> ox, oy, oz;
    alignas(16) Lanes<float> dx, dy, dz;
};

struct BundleHits {
    alignas(16) Lanes<float> distanceM;      ///< infinite for a sub-ray without a hit
    alignas(16) Lanes<std::int32_t> surface; ///< index into Scene::surfaces, or of a triangle of the copy; -1 without a hit
    alignas(16) Lanes<std::int32_t> copy;    ///< index into Scene::copies, -1 if the surface is not one of a copy

    BundleHits() {
        distanceM.fill(std::numeric_limits<float>::infinity());
        surface.fill(-1);
        copy.fill(-1);
    }
};

/// The largest distance among the lanes.
[[nodiscard]] inline float farthest(const BundleHits& hits) { return *std::max_element(hits.distanceM.begin(), hits.distanceM.end()); }

/// The end point of a sub-ray that hit a surface, metres.
[[nodiscard]] inline Eigen::Vector3f placeOf(const RayBundle& bundle, const BundleHits& hits, std::size_t lane) {
    const float t = hits.distanceM[lane];
    return {bundle.ox[lane] + t * bundle.dx[lane], bundle.oy[lane] + t * bundle.dy[lane], bundle.oz[lane] + t * bundle.dz[lane]};
}

/// Diameter of the beam = apertureM + divergenceRad * range.
struct Footprint {
    double apertureM = 0.013;
    double divergenceRad = 0.0046;

    [[nodiscard]] double radiusM(double rangeM) const { return 0.5 * (apertureM + divergenceRad * rangeM); }
};

/// The sub-rays of a beam along a unit direction, from the origin or another point.
[[nodiscard]] RayBundle bundleAlong(const Eigen::Vector3d& direction, const Footprint& footprint,
                                    const Eigen::Vector3d& fromM = Eigen::Vector3d::Zero());

/// Share of the beam's power in each sub-ray; the sum is 1.
[[nodiscard]] const Lanes<float>& subRayPower();

} // namespace edgescan::sim
