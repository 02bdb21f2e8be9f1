// The place of a scan in the mine: transforms from the scanner's frame to local east, north, up about an origin that is stored in double.
#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace edgescan {

struct Scan;

/// p_B = rotation p_A + translationM, in double. Rotations are proper: orthonormal, determinant +1.
struct RigidTransform {
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
    Eigen::Vector3d translationM = Eigen::Vector3d::Zero();

    [[nodiscard]] Eigen::Vector3d operator*(const Eigen::Vector3d& p) const { return rotation * p + translationM; }
    bool operator==(const RigidTransform&) const = default;
};

/// p_C = outer (inner p_A): first inner, then outer.
[[nodiscard]] inline RigidTransform operator*(const RigidTransform& outer, const RigidTransform& inner) {
    return {outer.rotation * inner.rotation, outer * inner.translationM};
}
[[nodiscard]] inline RigidTransform inverse(const RigidTransform& t) {
    return {t.rotation.transpose(), -(t.rotation.transpose() * t.translationM)};
}

/// How the sensor is mounted on the stepper (docs/reference/coordinates.md, "Step 1"). A scan's own points assume the ideal mounting.
struct StepperMount {
    RigidTransform sensorInMover; ///< M from S
    Eigen::Vector3d axis{0, 0, 1};
    double zeroDeg = 0.0;   ///< phi0: stepper angle of the scan's line angle 0
    double direction = 1.0; ///< +1 or -1: direction of the stepper relative to the scan's line angle

    bool operator==(const StepperMount&) const = default;
};

/// The boom that carries the head, metres in the axis base A. It does not rotate with the stepper (docs/reference/coordinates.md, "Step
/// 3").
struct Boom {
    Eigen::Vector3d pivotM = Eigen::Vector3d::Zero();
    Eigen::Vector3d headM = Eigen::Vector3d::UnitX(); ///< always different from the pivot

    bool operator==(const Boom&) const = default;
};

/// The frame of an export's coordinates.
enum class CoordinateFrame : std::uint8_t {
    Scanner,   ///< as measured, origin at the scanner
    MineLocal, ///< east, north, up from the origin, which is written in the header: small numbers
    Mine,      ///< Easting, Northing, Elevation; never in 4-byte floats
};

/// Immutable after construction.
struct Placement {
    StepperMount mount;
    std::vector<RigidTransform> poses{1};                 ///< axis base A -> metres from the origin; one for all lines, or one per line
    Eigen::Vector3d originEnhM = Eigen::Vector3d::Zero(); ///< Easting, Northing, Elevation of the local origin, whole metres
    double gridScale = 1.0;                               ///< grid metres per metre, horizontally (docs/reference/coordinates.md, "Step 5")
    std::string grid;                                     ///< "UTM 17N, WGS84" as the pose file gives it; may be empty
    std::string source;                                   ///< the files that it was computed from
    std::string robot;                                    ///< its name; may be empty
    std::string scanStartUtc, scanEndUtc;                 ///< of the scan, as the pose says; ISO 8601, empty if it does not
    std::string timeUtc;                                  ///< of the (last) pose, ISO 8601; empty if unknown
    double ageSeconds = 0.0;                              ///< start of the scan minus time of its pose; NaN if unknown
    bool outOfSpec = false;                               ///< the pose is older than allowed, or the tilt changed; the warnings say why
    std::vector<std::string> warnings;
    std::optional<Boom> boom; ///< empty if the calibration has no boom, or if the pose file gives the position of the head
};

} // namespace edgescan
