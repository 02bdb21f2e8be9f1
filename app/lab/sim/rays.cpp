// The sub-rays of a beam: the centre, a ring of four and a ring of six, each for about the same area.
#include "app/lab/sim/rays.h"

#include <Eigen/Geometry>

#include <cmath>

namespace edgescan::sim {
namespace {

struct SubRay {
    double u, v; ///< position in the unit disc
    float power; ///< before normalisation; the beam is brighter in the middle
};
constexpr std::array<SubRay, kSubRays> kPattern{{{0.0, 0.0, 1.0F},
                                                 {0.354, 0.354, 0.8F},
                                                 {-0.354, 0.354, 0.8F},
                                                 {-0.354, -0.354, 0.8F},
                                                 {0.354, -0.354, 0.8F},
                                                 {0.85, 0.0, 0.5F},
                                                 {0.425, 0.736, 0.5F},
                                                 {-0.425, 0.736, 0.5F},
                                                 {-0.85, 0.0, 0.5F},
                                                 {-0.425, -0.736, 0.5F},
                                                 {0.425, -0.736, 0.5F}}};

Lanes<float> normalisedPower() {
    Lanes<float> power{};
    float sum = 0.0F;
    for (const SubRay& ray : kPattern) sum += ray.power;
    for (std::size_t i = 0; i < kSubRays; ++i) power[i] = kPattern[i].power / sum;
    return power;
}

} // namespace

RayBundle bundleAlong(const Eigen::Vector3d& direction, const Footprint& footprint, const Eigen::Vector3d& fromM) {
    const Eigen::Vector3d aside = std::abs(direction.x()) < 0.7 ? Eigen::Vector3d::UnitX() : Eigen::Vector3d::UnitZ();
    const Eigen::Vector3d u = direction.cross(aside).normalized();
    const Eigen::Vector3d v = direction.cross(u);
    RayBundle bundle{};
    for (std::size_t i = 0; i < kLanes; ++i) {
        const SubRay& ray = kPattern[i < kSubRays ? i : 0];
        const Eigen::Vector3d offset = ray.u * u + ray.v * v;
        const Eigen::Vector3f origin = (fromM + 0.5 * footprint.apertureM * offset).cast<float>();
        const Eigen::Vector3f along = (direction + 0.5 * footprint.divergenceRad * offset).cast<float>();
        bundle.ox[i] = origin.x();
        bundle.oy[i] = origin.y();
        bundle.oz[i] = origin.z();
        bundle.dx[i] = along.x();
        bundle.dy[i] = along.y();
        bundle.dz[i] = along.z();
    }
    return bundle;
}

const Lanes<float>& subRayPower() {
    static const Lanes<float> power = normalisedPower();
    return power;
}

} // namespace edgescan::sim
