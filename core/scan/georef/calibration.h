// The values that are measured once per robot: how scanner, stepper, inclinometer, boom and TALIN are mounted. One readable file.
#pragma once

#include "core/base/result.h"
#include "core/scan/grid/placement.h"

#include <Eigen/Core>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace edgescan {

/// The direction of the scanner in the inclinometer's frame (docs/reference/coordinates.md, "Step 2").
enum class Viewing : std::uint8_t {
    Forward, ///< along the boom
    Up,      ///< straight up, with the underside to the front
    Down,    ///< straight down, as Up turned half about the line to the front: the scanner hangs
    Rpy,     ///< given by three angles
    Matrix,  ///< given by a matrix
};

enum class TiltReading : std::uint8_t {
    Elevations, ///< elevations of the X and Y axes above the horizon
    PitchRoll,  ///< Euler angles
};

inline constexpr const char* kHeadKey = "boom.head_in_robot_m";
inline constexpr const char* kConvergenceKey = "grid.convergence_deg";

struct Calibration {
    std::string robot; ///< its name; a pose file that names another robot is refused

    Eigen::Vector3d mountRpyDeg = Eigen::Vector3d::Zero(); ///< R_MS
    Eigen::Vector3d mountM = Eigen::Vector3d::Zero();      ///< t_MS
    Eigen::Vector3d axis{0, 0, 1};                         ///< rotation axis of the stepper in M: z = spin, x = sweep
    double degPerStep = 0.18;
    double zeroDeg = 0.0;           ///< phi0
    double direction = 1.0;         ///< +1 or -1
    double mirrorIndexDeg = -144.0; ///< a0: beam angle at the time stamp of a line (docs/developer/protocol.md, "Time of a beam")

    Viewing viewing = Viewing::Forward;
    Eigen::Vector3d viewingRpyDeg = Eigen::Vector3d::Zero();     ///< for Viewing::Rpy
    Eigen::Matrix3d viewingMatrix = Eigen::Matrix3d::Identity(); ///< for Viewing::Matrix
    Eigen::Vector3d inclinometerM = Eigen::Vector3d::Zero();     ///< t_IA
    TiltReading tilt = TiltReading::Elevations;

    bool slewAboutRobotZ = false; ///< the boom's azimuth is counted about the robot's Z axis, not about the vertical
    Eigen::Vector3d headInRobotM = Eigen::Vector3d::Zero(); ///< position of a fixed head, or of the pivot of a boom
    Eigen::Vector3d armM = Eigen::Vector3d::Zero();         ///< from pivot to head, in the inclinometer's axes

    Eigen::Vector3d talinInRobotM = Eigen::Vector3d::Zero();
    Eigen::Vector3d boresightRpyDeg = Eigen::Vector3d::Zero();

    double convergenceDeg = 0.0; ///< grid convergence, subtracted from a true heading
    double gridScale = 1.0;

    double tiltChangeLimitDeg = 0.2; ///< a larger change of tilt during a static sweep makes the scan OUT OF SPEC
    double poseAgeLimitS = 0.0;      ///< a pose may be this much older than the start of the scan

    std::vector<std::string> leftOut{}; ///< keys of measured mountings that the file does not name; their values are 0
};

/// Error: unknown key, missing unit in a name, number outside its limits, not a rotation, axis of length 0. `where` is the path.
Result<Calibration> parseCalibration(std::string_view json, const std::string& where);
Result<Calibration> openCalibration(const std::filesystem::path& path);

/// T_IA.
[[nodiscard]] RigidTransform inclinometerFromAxisBase(const Calibration& calibration);
[[nodiscard]] StepperMount stepperMount(const Calibration& calibration);
/// From pivot to head; empty without a boom.
[[nodiscard]] std::optional<Boom> boomOf(const Calibration& calibration);

} // namespace edgescan
