// The start and the direction of each ray of a sweep.
#pragma once

#include "core/scan/georef/assembly.h"
#include "core/scan/georef/rotations.h"
#include "core/scan/grid/cartesian.h"

#include <cmath>

namespace edgescan::sim {

struct Ray {
    Eigen::Vector3d fromM = Eigen::Vector3d::Zero();
    Eigen::Vector3d direction;
};

/// True angles and mounting. `angles` must outlive this object.
class BeamDirections {
public:
    /// `station`: from the scanner's frame to that of the scene.
    BeamDirections(const Scan& angles, const AssemblyErrors& assembly, const RigidTransform& station = {})
        : polar_(std::get<PolarGeometry>(angles.geometry)), tables_(angles), mount_(sensorInMover(polar_.axis, assembly)),
          station_(station), ideal_(assembly == AssemblyErrors{}), first_(station == RigidTransform{}) {}

    [[nodiscard]] Ray ray(int line, int beam) const {
        const Ray ray = rayOfScanner(line, beam);
        return first_ ? ray : Ray{station_ * ray.fromM, station_.rotation * ray.direction};
    }
    [[nodiscard]] const CartesianTables& tables() const { return tables_; }
    /// Where the beams start: around a centre, at most this far from it.
    [[nodiscard]] const Eigen::Vector3d& centreM() const { return station_.translationM; }
    [[nodiscard]] double leverM() const { return mount_.translationM.norm(); }

private:
    [[nodiscard]] Ray rayOfScanner(int line, int beam) const {
        if (ideal_) return {Eigen::Vector3d::Zero(), tables_.direction(line, beam)};
        const auto j = static_cast<std::size_t>(beam);
        const double angle =
            radians(polar_.lineDeg[static_cast<std::size_t>(line)] + (polar_.lineSkewDeg.empty() ? 0 : polar_.lineSkewDeg[j]));
        const Eigen::Matrix3d turn = polar_.axis == Axis::Spin ? rotationZ(angle) : rotationX(angle);
        const double a = radians(polar_.beamDeg[j]);
        return {turn * mount_.translationM, turn * (mount_.rotation * Eigen::Vector3d(std::cos(a), 0, std::sin(a)))};
    }

    const PolarGeometry& polar_;
    CartesianTables tables_;
    RigidTransform mount_, station_;
    bool ideal_; ///< no error of the assembly
    bool first_; ///< the scanner's frame is that of the scene
};

} // namespace edgescan::sim
