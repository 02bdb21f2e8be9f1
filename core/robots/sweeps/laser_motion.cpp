// The axis and the angles of a laser that is turned.
#include "core/robots/sweeps/laser_motion.h"
#include "core/base/translated_text.h"

#include "core/base/angles.h"
#include "core/base/number_text.h"
#include "core/robots/sweeps/each_message.h"
#include "core/scan/georef/rotations.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace edgescan::robots {
namespace {

constexpr double kMostWobbleDeg = 1.0;      // of a rotation about one axis
constexpr double kMostOutOfPlaneDeg = 30.0; // a fan that turns in its own plane, or nearly so, does not sweep

/// The axis of most of the rotations from the first pose, as a unit vector in the frame; the angle of the largest.
std::pair<Eigen::Vector3d, double> axisOf(const std::vector<TimedPose>& poses) {
    Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();
    double most = 0;
    for (const TimedPose& pose : poses) {
        const Eigen::AngleAxisd turn(poses.front().rotation.conjugate() * pose.rotation);
        if (std::abs(turn.angle()) <= most) continue;
        most = std::abs(turn.angle());
        axis = turn.angle() < 0 ? -turn.axis() : turn.axis();
    }
    return {axis, degrees(most)};
}

/// The angle about `axis` (of swing and twist the twist), and how far the rest of the rotation is.
std::pair<double, double> twistDeg(const Eigen::Quaterniond& rotation, const Eigen::Vector3d& axis) {
    const double along = rotation.vec().dot(axis);
    const double angle = 2 * std::atan2(along, rotation.w());
    const Eigen::Quaterniond twist(Eigen::AngleAxisd(angle, axis));
    return {degrees(std::remainder(angle, 2 * 3.14159265358979323846)), degrees(rotation.angularDistance(twist))};
}

/// Whole hundredths of a degree that were rounded on their way are whole again.
double withoutNoise(double deg) {
    constexpr double kNoiseDeg = 2e-5; // floats of 4 bytes in radians
    const double whole = std::round(deg * 100) / 100;
    return std::abs(deg - whole) < kNoiseDeg ? whole : deg;
}

/// The angle of a joint that gives this rotation behind a fixed one: the twist. 0 where the fixed one turns the axis round, which leaves it
/// open.
double angleOfJoint(const Eigen::Quaterniond& rotation, const Eigen::Vector3d& axis) {
    constexpr double kLeast = 0.05;
    return std::hypot(rotation.vec().dot(axis), rotation.w()) < kLeast ? 0.0 : twistDeg(rotation, axis).first;
}

std::vector<TimedPose> within(const FrameLink& link, std::int64_t fromNs, std::int64_t toNs) {
    std::vector<TimedPose> poses;
    for (std::size_t n = 0; n < link.poses.size(); ++n) {
        const bool before = n + 1 < link.poses.size() && link.poses[n + 1].ns < fromNs;
        const bool after = n > 0 && link.poses[n - 1].ns > toNs;
        if (!before && !after) poses.push_back(link.poses[n]);
    }
    return poses;
}

/// Angles that begin again at half a turn go on instead.
void goOn(std::vector<TimedAngle>& angles) {
    for (std::size_t n = 1; n < angles.size(); ++n) angles[n].deg += 360 * std::round((angles[n - 1].deg - angles[n].deg) / 360);
}

/// A wheel turns further than a scanner's joint: the name decides where it can.
bool turnsScanner(const std::string& joint) {
    constexpr std::array<std::string_view, 7> kWords{"laser", "lidar", "scan", "tilt", "nod", "hokuyo", "lms"};
    return std::ranges::any_of(kWords, [&](std::string_view word) { return joint.find(word) != std::string::npos; });
}

/// A laser looks along 0 degrees and has its fan level: what tilts it turns about the line across.
Axis axisByName(const std::string& joint) {
    constexpr std::array<std::string_view, 3> kTilts{"tilt", "nod", "pitch"};
    return std::ranges::any_of(kTilts, [&](std::string_view word) { return joint.find(word) != std::string::npos; }) ? Axis::Sweep
                                                                                                                     : Axis::Spin;
}

std::string namesOf(const JointAngles& joints) {
    constexpr std::size_t kMost = 500;
    std::string names;
    for (const auto& [name, angles] : joints) {
        if (names.size() > kMost) return withValues("%1 and others", {names});
        names += (names.empty() ? "" : ", ") + name;
    }
    return names;
}

} // namespace

AngleAt angleAt(const std::vector<TimedAngle>& angles, std::int64_t ns) {
    const auto after = std::ranges::upper_bound(angles, ns, {}, &TimedAngle::ns);
    if (angles.size() < 2) return {angles.empty() ? 0.0 : angles.front().deg, 0, false};
    const bool inside = ns >= angles.front().ns && ns <= angles.back().ns;
    const auto to = after == angles.begin() ? std::next(after) : after == angles.end() ? std::prev(after) : after;
    const TimedAngle &a = *std::prev(to), &b = *to;
    const auto whole = static_cast<double>(b.ns - a.ns);
    const double share = std::clamp(static_cast<double>(ns - a.ns) / whole, 0.0, 1.0);
    return {a.deg + share * (b.deg - a.deg), (b.deg - a.deg) / (whole * 1e-9), inside};
}

double forwardShiftDeg(double fanMiddleDeg) { return std::abs(fanMiddleDeg) < 45 ? -90.0 : 0.0; }

Result<LaserMotion> motionByFrames(const FrameTree& tree, const std::string& frame, double fanMiddleDeg, std::int64_t fromNs,
                                   std::int64_t toNs, const std::string& where) {
    RigidTransform laserInMover; // the moving frame from the laser's, through links that do not turn
    for (const std::string& at : tree.chain(frame)) {
        const FrameLink* link = tree.link(at);
        if (link == nullptr) break;
        const std::vector<TimedPose> poses = within(*link, fromNs, toNs);
        const auto [axis, turnDeg] = axisOf(poses);
        if (turnDeg < kLeastTurnDeg) {
            if (const auto fixed = tree.inParent(at, fromNs)) laserInMover = *fixed * laserInMover;
            continue;
        }
        LaserMotion motion;
        motion.mover = at;
        motion.source = withValues("the transform of the frame %1 in %2", {at, link->parent});
        double wobble = 0, last = 0;
        const double startDeg = angleOfJoint(poses.front().rotation, axis);
        for (const TimedPose& pose : poses) {
            auto [deg, rest] = twistDeg(poses.front().rotation.conjugate() * pose.rotation, axis);
            deg += startDeg;
            deg += 360 * std::round((last - deg) / 360); // on from the last one
            wobble = std::max(wobble, rest);
            motion.angles.push_back({pose.ns, last = deg});
        }
        if (wobble > kMostWobbleDeg)
            return Error{withValues("%1 turns about more than one axis (%2 degrees off)", {motion.source, significantText(wobble, 2)}),
                         where, "choose another topic, or give the joint that turns the laser"};
        Eigen::Vector3d u = laserInMover.rotation.transpose() * axis;
        motion.outOfPlaneDeg = std::abs(degrees(std::asin(std::clamp(u.z(), -1.0, 1.0))));
        if (motion.outOfPlaneDeg > kMostOutOfPlaneDeg)
            return Error{withValues("%1 turns the laser in the plane of its own fan: that is not a sweep", {motion.source}), where,
                         "choose another topic"};
        motion.offAxisM = laserInMover.translationM.cross(axis).norm();
        // The axis from the middle of the fan on: 0 is a spin, -90 a sweep, and 180 more is the axis the other way round.
        double fromMiddle = std::remainder(degrees(std::atan2(u.y(), u.x())) - fanMiddleDeg, 360.0);
        const bool spin = std::abs(fromMiddle) <= 45 || std::abs(fromMiddle) >= 135;
        const bool turnAbout = spin ? std::abs(fromMiddle) > 90 : fromMiddle > 0;
        if (turnAbout) {
            fromMiddle = std::remainder(fromMiddle + 180, 360.0);
            for (TimedAngle& angle : motion.angles) angle.deg = -angle.deg;
        }
        motion.axis = spin ? Axis::Spin : Axis::Sweep;
        motion.beamShiftDeg = withoutNoise(fanMiddleDeg + fromMiddle - (spin ? 90 : 0));
        motion.baseFrame = link->parent;
        motion.base = {poses.front().rotation.toRotationMatrix(), poses.front().translationM};
        const Eigen::Matrix3d fan = rotationZ(radians(motion.beamShiftDeg)) * rotationX(radians(-90.0)); // laser from the scan's own frame
        motion.mount = {laserInMover * RigidTransform{fan, Eigen::Vector3d::Zero()}, axis, -startDeg, turnAbout ? -1.0 : 1.0};
        return motion;
    }
    return Error{withValues("no transform turns the laser's frame %1 while it measures", {frame}), where,
                 "give the joint that turns it (--joint), or the step from line to line (--line-step) and the axis (--axis)"};
}

double laterAngleDeg(const LaserMotion& motion, const TimedPose& pose) {
    const Eigen::Quaterniond first(motion.base.rotation);
    const double raw = twistDeg(first.conjugate() * pose.rotation, motion.mount.axis).first - motion.mount.zeroDeg;
    const double deg = motion.mount.direction * raw;
    return deg + 360 * std::round((motion.angles.back().deg - deg) / 360);
}

void addJoints(JointAngles& joints, const RosValue& message) {
    constexpr std::size_t kMostJoints = 1000;
    const auto ns = stampNs(message, "header.stamp");
    const std::vector<double> positions = message.numbers("position");
    const RosValue* names = message.at("name");
    for (std::size_t n = 0; ns && names != nullptr && n < std::min({positions.size(), names->inside.size(), kMostJoints}); ++n) {
        const ByteView name = names->inside[n].bytes;
        const std::string joint(name.begin(), name.end());
        if (std::isfinite(positions[n]) && (joints.size() < kMostJoints || joints.contains(joint)))
            joints[joint].push_back({*ns, degrees(positions[n])});
    }
}

Result<LaserMotion> motionByJoint(const RosBag& bag, const std::string& joint, std::int64_t fromNs, std::int64_t toNs,
                                  const std::string& where, const std::function<bool()>& goOn) {
    constexpr std::int64_t kAroundNs = 1'000'000'000;
    JointAngles joints;
    std::size_t damaged = 0;
    const auto addMessage = [&](std::uint32_t, const RosValue& message) {
        const auto ns = stampNs(message, "header.stamp");
        if (ns && *ns >= fromNs - kAroundNs && *ns <= toNs + kAroundNs) addJoints(joints, message);
    };
    const auto read = eachMessage(
        bag, [](const std::string& type) { return type == "sensor_msgs/JointState"; }, where, addMessage, [&] { ++damaged; }, goOn);
    if (!read) return read.error();
    auto motion = motionOfJoints(std::move(joints), joint, where);
    if (motion) motion->damagedMessages = damaged;
    return motion;
}

Result<LaserMotion> motionOfJoints(JointAngles joints, const std::string& joint, const std::string& where) {
    std::string best = joint;
    double most = 0;
    bool named = false;
    for (auto& [name, angles] : joints) {
        std::ranges::stable_sort(angles, {}, &TimedAngle::ns);
        angles.erase(std::unique(angles.begin(), angles.end(), [](const auto& a, const auto& b) { return a.ns == b.ns; }), angles.end());
        goOn(angles);
        const auto [low, high] = std::ranges::minmax_element(angles, {}, &TimedAngle::deg);
        const double turned = high->deg - low->deg;
        if (!joint.empty() || turned < kLeastTurnDeg || std::pair(turnsScanner(name), turned) <= std::pair(named, most)) continue;
        most = turned;
        named = turnsScanner(name);
        best = name;
    }
    if (!joints.contains(best))
        return Error{joint.empty() ? "no joint turned while the laser measured" : withValues("there is no joint called %1", {joint}), where,
                     joints.empty() ? "give the step from line to line (--line-step), or choose another topic"
                                    : withValues("choose one of %1", {namesOf(joints)})};
    LaserMotion motion;
    motion.axis = axisByName(best);
    motion.axisAssumed = true;
    motion.mover = best;
    motion.source = withValues("the joint %1", {best});
    motion.angles = std::move(joints[best]);
    return motion;
}

} // namespace edgescan::robots
