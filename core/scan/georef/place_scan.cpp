// Computes the place of a scan from calibration and readings, and warns about doubtful values.
#include "core/scan/georef/place_scan.h"
#include "core/base/translated_text.h"

#include "core/base/number_text.h"
#include "core/base/sha256.h"
#include "core/base/utc_time.h"
#include "core/scan/georef/chain.h"
#include "core/scan/georef/rotations.h"
#include "core/scan/georef/utm_zone.h"
#include "core/scan/grid/assumed_mounting.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace edgescan {
namespace {

using Eigen::Vector3d;

// a larger difference between calibrated and ideal axis means another mounting, not a misalignment
constexpr double kMountingToleranceDeg = 10.0;

std::string shortNumber(double value) { return significantText(value, 3); }

Error refused(const PoseTrack& poses, std::string what, std::string hint) { return {std::move(what), poses.source, std::move(hint)}; }

Result<Done> checkTogether(const Scan& scan, const Calibration& calibration, const PoseTrack& poses) {
    if (!poses.robot.empty() && !calibration.robot.empty() && poses.robot != calibration.robot) {
        return refused(poses, withValues("the pose is of robot \"%1\" and the calibration of \"%2\"", {poses.robot, calibration.robot}),
                       "give the calibration of the robot that made the scan");
    }
    const auto* polar = std::get_if<PolarGeometry>(&scan.geometry);
    if (polar == nullptr) return Done{};
    const Vector3d ideal = polar->axis == Axis::Sweep ? Vector3d::UnitX() : Vector3d::UnitZ();
    const double off = degrees(std::acos(std::clamp(calibration.axis.normalized().dot(ideal), -1.0, 1.0)));
    if (off <= kMountingToleranceDeg) return Done{};
    return refused(
        poses,
        withValues("the scan turns about %1 and the stepper of the calibration about another axis, %2 degrees away",
                   {polar->axis == Axis::Sweep ? "x (sweep)" : "z (spin)", shortNumber(off)}),
        "open the scan with the right --axis, or correct \"stepper.axis\" of the calibration: [0, 0, 1] for a spin, [1, 0, 0] for a sweep");
}

/// Converts the readings of one moment to the transform of the whole chain. Error: angles that exclude each other.
Result<RigidTransform> poseAt(const Calibration& c, const PoseTrack& poses, const InclinometerReading& tilt, const TalinReading& talin,
                              const Vector3d& originEnhM) {
    Result<PitchRoll> head = PitchRoll{tilt.tiltXDeg, tilt.tiltYDeg};
    if (c.tilt == TiltReading::Elevations) head = pitchRollOfElevations(tilt.tiltXDeg, tilt.tiltYDeg);
    if (!head) return refused(poses, head.error().what, head.error().hint);
    const double heading = talin.trueNorth ? gridHeadingDeg(talin.headingDeg, c.convergenceDeg) : talin.headingDeg;
    MomentPose moment;
    moment.inclinometerFromAxisBase = inclinometerFromAxisBase(c);
    moment.head = *head;
    moment.boomAzimuthDeg = poses.boomAzimuthDeg;
    moment.slewAboutRobotZ = c.slewAboutRobotZ;
    const bool given = poses.headInRobotM.allFinite();
    moment.headInRobotM = given ? poses.headInRobotM : c.headInRobotM;
    moment.armM = given ? Vector3d(Vector3d::Zero()) : c.armM;
    moment.vehicleFromRobot = vehicleFromRobot(c.boresightRpyDeg, c.talinInRobotM);
    moment.nedFromVehicle = nedFromVehicle(heading, talin.pitchDeg, talin.rollDeg);
    moment.talinEnhM = talin.enhM;
    auto pose = localFromAxisBase(moment, originEnhM, c.gridScale);
    if (!pose) return refused(poses, pose.error().what, pose.error().hint);
    return pose;
}

/// The time of each line; empty if unknown.
Result<std::vector<double>> timesOfLines(const Scan& scan, const PoseTrack& poses, std::span<const double> given) {
    const auto lines = static_cast<std::size_t>(scan.lines());
    if (!given.empty() && given.size() != lines) {
        return refused(poses, withValues("%1 line times do not fit a scan of %2 lines", {given.size(), lines}),
                       "give the times of this scan");
    }
    if (!given.empty()) return std::vector<double>(given.begin(), given.end());
    if (!std::isfinite(poses.scanStartS) || !std::isfinite(poses.scanEndS)) return std::vector<double>{};
    std::vector<double> times(lines, poses.scanStartS);
    for (std::size_t i = 0; i < lines && lines > 1; ++i)
        times[i] += (poses.scanEndS - poses.scanStartS) * static_cast<double>(i) / static_cast<double>(lines - 1);
    return times;
}

void warn(Placement& placement, bool outOfSpec, const std::string& sentence) {
    placement.warnings.push_back((outOfSpec ? "OUT OF SPEC: " : "") + sentence);
    placement.outOfSpec = placement.outOfSpec || outOfSpec;
}

/// The older one of the newest inclinometer reading and the newest TALIN reading.
double newestTime(const PoseTrack& poses) {
    const double a = poses.inclinometer.back().timeS;
    const double b = poses.talin.back().timeS;
    return std::isnan(a) || std::isnan(b) ? kUnknownTime : std::min(a, b);
}

void judgeAge(Placement& placement, const Calibration& calibration, double poseTimeS, double startS) {
    placement.timeUtc = utcText(poseTimeS);
    placement.ageSeconds = startS - poseTimeS;
    if (std::isnan(poseTimeS)) return warn(placement, false, "The pose carries no time, so its age is not known.");
    if (std::isnan(startS)) return warn(placement, false, "The start of the scan is not known, so the age of the pose is not either.");
    if (placement.ageSeconds <= calibration.poseAgeLimitS) return;
    warn(placement, true, withValues("the pose is %1 s older than the start of the scan.", {shortNumber(placement.ageSeconds)}));
}

void judgeStillness(Placement& placement, const Calibration& calibration, const PoseTrack& poses) {
    double leastX = 1e9, mostX = -1e9, leastY = 1e9, mostY = -1e9;
    for (const InclinometerReading& r : poses.inclinometer) {
        leastX = std::min(leastX, r.tiltXDeg);
        mostX = std::max(mostX, r.tiltXDeg);
        leastY = std::min(leastY, r.tiltYDeg);
        mostY = std::max(mostY, r.tiltYDeg);
    }
    const double change = std::max(mostX - leastX, mostY - leastY);
    if (change <= calibration.tiltChangeLimitDeg) return;
    warn(placement, true,
         withValues("the tilt of the head changed by %1 degrees while it scanned, more than %2.",
                    {shortNumber(change), shortNumber(calibration.tiltChangeLimitDeg)}));
}

/// Warns about mountings that were not measured. A head that the pose gives and headings from the grid's north need no value.
void judgeMounting(Placement& placement, const Calibration& calibration, const PoseTrack& poses) {
    std::string names;
    for (const std::string& key : calibration.leftOut) {
        if (key == kHeadKey && poses.headInRobotM.allFinite()) continue;
        if (key == kConvergenceKey && std::ranges::none_of(poses.talin, &TalinReading::trueNorth)) continue;
        names += (names.empty() ? "" : ", ") + key;
    }
    if (!names.empty())
        warn(placement, false,
             withValues("The calibration does not give %1, so 0 is used: add what is missing (Scan > Pose and Mounting, page Mounting).",
                        {names}));
}

/// Warns about lines measured before the first or after the last reading: their pose is a guess.
void judgeCover(Placement& placement, const PoseTrack& poses, const std::vector<double>& times) {
    const double first = std::max(poses.inclinometer.front().timeS, poses.talin.front().timeS);
    const double last = newestTime(poses);
    const auto outside = std::count_if(times.begin(), times.end(), [&](double t) { return !(t >= first && t <= last); });
    if (outside == 0) return;
    warn(placement, true,
         withValues("%1 of %2 lines were measured before the first or after the last pose and were given the nearest one.",
                    {outside, times.size()}));
}

} // namespace

void judgeSpeed(Placement& placement, std::span<const double> timesS) {
    constexpr double kFastestMPerS = 30, kLeastM = 0.1; // a hundred km/h; less than this is noise of the poses
    double fastest = 0;
    for (std::size_t n = 1; n < std::min(placement.poses.size(), timesS.size()); ++n) {
        const double seconds = timesS[n] - timesS[n - 1];
        const double metres = (placement.poses[n].translationM - placement.poses[n - 1].translationM).norm();
        if (metres > kLeastM && seconds > 0) fastest = std::max(fastest, metres / seconds);
    }
    if (fastest > kFastestMPerS)
        warn(placement, true,
             withValues("the poses move the base at %1 m/s between two lines, faster than any machine under ground.",
                        {shortNumber(fastest)}));
}

namespace {

/// A place that the zone of the pose cannot hold.
void judgeZone(Placement& placement, double eastingM) {
    const auto zone = utmZone(placement.grid);
    constexpr NumberLimits kEastings{100'000, 900'000};
    if (zone && !zone->exists())
        warn(placement, true, withValues("the zone \"%1\" does not exist: UTM has zones 1 to 60.", {placement.grid}));
    else if (zone && !kEastings.hold(eastingM))
        warn(placement, true,
             withValues("an easting of %1 m is outside of every UTM zone: check whether easting and northing are exchanged.",
                        {fixedText(eastingM, 0)}));
}

Result<Done> placeLines(Placement& placement, const Calibration& calibration, const PoseTrack& poses, const std::vector<double>& times) {
    placement.poses.clear();
    for (const double t : times) {
        const auto pose = poseAt(calibration, poses, inclinometerAt(poses.inclinometer, t), talinAt(poses.talin, t), placement.originEnhM);
        if (!pose) return pose.error();
        placement.poses.push_back(*pose);
    }
    return Done{};
}

} // namespace

Result<std::shared_ptr<const Placement>> placeScan(const Scan& scan, const Calibration& calibration, const PoseTrack& poses,
                                                   std::span<const double> lineTimesS) {
    if (poses.inclinometer.empty() || poses.talin.empty())
        return refused(poses, "there is no pose", "give readings of inclinometer and TALIN");
    if (auto fits = checkTogether(scan, calibration, poses); !fits) return fits.error();
    const auto times = timesOfLines(scan, poses, lineTimesS);
    if (!times) return times.error();
    auto placement = std::make_shared<Placement>();
    placement->mount = stepperMount(calibration);
    placement->gridScale = calibration.gridScale;
    if (!poses.headInRobotM.allFinite()) placement->boom = boomOf(calibration);
    placement->grid = poses.grid;
    placement->source = poses.source;
    placement->robot = poses.robot.empty() ? calibration.robot : poses.robot;
    placement->scanStartUtc = utcText(poses.scanStartS);
    placement->scanEndUtc = utcText(poses.scanEndS);
    const TalinReading mean = averageTalin(poses.talin);
    placement->originEnhM = chooseOrigin(mean.enhM);
    if (assumedIn(scan) != Assumed::Nothing)
        warn(*placement, true,
             "the angles of the stepper are assumed, so E, N and RL may be wrong: give mounting, step and angle of the first line.");
    judgeMounting(*placement, calibration, poses);
    judgeZone(*placement, mean.enhM.x());
    const double startS = lineTimesS.empty() ? poses.scanStartS : lineTimesS.front();
    if (poses.moving) {
        if (times->empty()) {
            return refused(poses, "the base moved and the times of the lines are not known",
                           "add \"scan_start\" and \"scan_end\" to the pose file");
        }
        if (auto placed = placeLines(*placement, calibration, poses, *times); !placed) return placed.error();
        judgeCover(*placement, poses, *times);
        judgeSpeed(*placement, *times);
        judgeAge(*placement, calibration, newestTime(poses), startS);
    } else {
        const auto pose = poseAt(calibration, poses, averageInclinometer(poses.inclinometer), mean, placement->originEnhM);
        if (!pose) return pose.error();
        placement->poses = {*pose};
        judgeAge(*placement, calibration, newestTime(poses), startS);
        judgeStillness(*placement, calibration, poses);
    }
    return std::shared_ptr<const Placement>(placement);
}

Result<std::string> sourceOf(const std::filesystem::path& file) {
    const auto hash = sha256OfFile(file);
    if (!hash) return hash.error();
    return file.filename().string() + " (SHA-256 " + *hash + ")";
}

Result<std::shared_ptr<const Placement>> openPlacement(const std::filesystem::path& pose, const std::filesystem::path& calibration,
                                                       const Scan& scan, std::span<const double> lineTimesS) {
    auto robot = calibration.empty() ? Result<Calibration>(Calibration{}) : openCalibration(calibration);
    if (!robot) return robot.error();
    const auto poses = openPoses(pose);
    if (!poses) return poses.error();
    if (calibration.empty()) {
        if (!poses->calibration) return Error{"a pose needs the robot's calibration", pose.string(), "give --calibration ROBOT.json too"};
        robot = *poses->calibration;
    }
    const auto poseSource = sourceOf(pose);
    const auto robotSource = calibration.empty() ? Result<std::string>(std::string()) : sourceOf(calibration);
    if (!poseSource || !robotSource) return poseSource ? robotSource.error() : poseSource.error();
    const auto placed = placeScan(scan, *robot, *poses, lineTimesS);
    if (!placed) return Error{placed.error().what, pose.string(), placed.error().hint};
    auto named = std::make_shared<Placement>(**placed);
    if (!calibration.empty() && poses->calibration)
        named->warnings.push_back(withValues("--calibration replaces the calibration in %1.", {pose.filename().string()}));
    if (scan.placement) {
        const auto place = [](const Placement& of) -> Vector3d { return of.originEnhM + of.poses.front().translationM; };
        const Vector3d before = place(*scan.placement), now = place(*named);
        named->warnings.push_back(withValues(
            "The pose in %1 replaces the place that the file gives: E %2, N %3 m in place of E %4, N %5 m.",
            {pose.filename().string(), fixedText(now.x(), 3), fixedText(now.y(), 3), fixedText(before.x(), 3), fixedText(before.y(), 3)}));
    }
    named->source = *poseSource + (robotSource->empty() ? "" : withValues(" with %1", {*robotSource}));
    return std::shared_ptr<const Placement>(named);
}

} // namespace edgescan
