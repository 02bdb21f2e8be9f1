// The place of the robot and the tilt of the head during the scan: readings with their times, and the pose of each line made from them.
#pragma once

#include "core/base/result.h"
#include "core/scan/georef/calibration.h"
#include "core/scan/grid/placement.h"
#include "core/scan/grid/scan.h"

#include <Eigen/Core>

#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace edgescan {

inline constexpr double kUnknownTime = std::numeric_limits<double>::quiet_NaN();

struct InclinometerReading {
    double timeS = kUnknownTime; ///< seconds since 1970 UTC
    double tiltXDeg = 0.0;
    double tiltYDeg = 0.0;
};

struct TalinReading {
    double timeS = kUnknownTime;
    Eigen::Vector3d enhM = Eigen::Vector3d::Zero(); ///< Easting, Northing, Elevation
    double headingDeg = 0.0;                        ///< clockwise from north
    bool trueNorth = true;                          ///< false: relative to the grid's north
    double pitchDeg = 0.0;                          ///< nose up
    double rollDeg = 0.0;                           ///< right side down
};

/// The content of one pose file.
struct PoseTrack {
    std::string robot; ///< empty, or the name of the robot in the calibration
    std::string source;
    std::string grid;                 ///< zone and datum, as TALIN gives them
    double scanStartS = kUnknownTime; ///< UTC
    double scanEndS = kUnknownTime;
    bool moving = false;         ///< true: the base moved, so each line has a pose; false: one pose, averaged over the sweep
    double boomAzimuthDeg = 0.0; ///< positive to the left
    Eigen::Vector3d headInRobotM = Eigen::Vector3d::Constant(kUnknownTime); ///< NaN: the value of the calibration
    std::vector<InclinometerReading> inclinometer;                          ///< at least one, with ascending times where known
    std::vector<TalinReading> talin;                                        ///< at least one
    std::optional<Calibration> calibration;                                 ///< of the robot, if the pose file holds it
};

/// Reads a pose file: {"format": "edgescan-pose/1", ...}. Error: unknown key, number outside its limits, times out of order ... `where` is
/// the path.
Result<PoseTrack> parsePoses(std::string_view json, const std::string& where);
Result<PoseTrack> openPoses(const std::filesystem::path& path);

/// The reading at a time, interpolated linearly. Before the first reading: the first one. After the last reading: the last one.
[[nodiscard]] InclinometerReading inclinometerAt(std::span<const InclinometerReading> readings, double timeS);
/// The position is interpolated linearly, the attitude by slerp.
[[nodiscard]] TalinReading talinAt(std::span<const TalinReading> readings, double timeS);

/// Mean of tilts; mean position and mean attitude.
[[nodiscard]] InclinometerReading averageInclinometer(std::span<const InclinometerReading> readings);
[[nodiscard]] TalinReading averageTalin(std::span<const TalinReading> readings);

/// Computes the place of a scan. `lineTimesS`: the UTC time of each line; empty = evenly from scan start to end. Error: another robot, a
/// mounting other than the scan's, angles that exclude each other. Doubtful but usable values are listed in Placement::warnings.
Result<std::shared_ptr<const Placement>> placeScan(const Scan& scan, const Calibration& calibration, const PoseTrack& poses,
                                                   std::span<const double> lineTimesS = {});

/// "pose.json (SHA-256 ...)": the name of a file in Placement::source.
Result<std::string> sourceOf(const std::filesystem::path& file);

/// Reads both files and computes the place of the scan, for --pose POSE.json --calibration ROBOT.json. An empty path: the pose file holds
/// the calibration.
Result<std::shared_ptr<const Placement>> openPlacement(const std::filesystem::path& pose, const std::filesystem::path& calibration,
                                                       const Scan& scan, std::span<const double> lineTimesS = {});

/// Poses of the lines that move the base faster than any machine get a warning. `timesS`: of the lines.
void judgeSpeed(Placement& placement, std::span<const double> timesS);

} // namespace edgescan
