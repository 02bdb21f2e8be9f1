// What is measured once per robot: how scanner, stepper, inclinometer, boom and TALIN sit on it. One readable file.
#pragma once

#include "core/base/result.h"
#include "core/scan/grid/placement.h"

#include <Eigen/Core>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace edgescan {

/// Which way the scanner looks in the inclinometer's frame (docs/coordinates.md, "Step 2").
enum class Viewing : std::uint8_t {
    Forward, ///< along the boom
    Up,      ///< straight up, underside to the front
    Rpy,     ///< as the three angles say
    Matrix,  ///< as the matrix says
};

enum class TiltReading : std::uint8_t {
    Elevations, ///< of the X and Y axes above the horizon
    PitchRoll,  ///< Euler angles
};

struct Calibration {
    std::string robot; ///< its name; a pose that names another robot is refused

    Eigen::Vector3d mountRpyDeg = Eigen::Vector3d::Zero(); ///< R_MS
    Eigen::Vector3d mountM = Eigen::Vector3d::Zero();      ///< t_MS
    Eigen::Vector3d axis{0, 0, 1};                         ///< the stepper turns about it, in M: z = spin, x = sweep
    double degPerStep = 0.18;
    double zeroDeg = 0.0;           ///< phi0
    double direction = 1.0;         ///< +1 or -1
    double mirrorIndexDeg = -144.0; ///< a0: beam angle at the time stamp of a line (docs/protocol.md, "Time of a beam")

    Viewing viewing = Viewing::Forward;
    Eigen::Vector3d viewingRpyDeg = Eigen::Vector3d::Zero();     ///< for Viewing::Rpy
    Eigen::Matrix3d viewingMatrix = Eigen::Matrix3d::Identity(); ///< for Viewing::Matrix
    Eigen::Vector3d inclinometerM = Eigen::Vector3d::Zero();     ///< t_IA
    TiltReading tilt = TiltReading::Elevations;

    bool slewAboutRobotZ = false;                           ///< the boom's azimuth is counted about the robot's Z axis, not the vertical
    Eigen::Vector3d headInRobotM = Eigen::Vector3d::Zero(); ///< of a fixed head, or the pivot of a boom
    Eigen::Vector3d armM = Eigen::Vector3d::Zero();         ///< pivot to head, in the inclinometer's axes

    Eigen::Vector3d talinInRobotM = Eigen::Vector3d::Zero();
    Eigen::Vector3d boresightRpyDeg = Eigen::Vector3d::Zero();

    double convergenceDeg = 0.0; ///< grid convergence, taken off a true heading
    double gridScale = 1.0;

    double tiltChangeLimitDeg = 0.2; ///< more than this during a static sweep is OUT OF SPEC
    double poseAgeLimitS = 0.0;      ///< a pose may be this much older than the start of the scan
};

/// Error: unknown key, missing unit in a name, number outside its limits, no rotation, axis without direction. `where` is the path.
Result<Calibration> parseCalibration(std::string_view json, const std::string& where);
Result<Calibration> openCalibration(const std::filesystem::path& path);

/// T_IA.
[[nodiscard]] RigidTransform inclinometerFromAxisBase(const Calibration& calibration);
[[nodiscard]] StepperMount stepperMount(const Calibration& calibration);
/// From pivot to head; empty without an arm.
[[nodiscard]] std::optional<Boom> boomOf(const Calibration& calibration);

} // namespace edgescan
