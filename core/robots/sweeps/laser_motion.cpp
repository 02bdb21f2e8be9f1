// The axis and the angles of a laser that is turned.
#include "core/robots/sweeps/laser_motion.h"

#include "core/base/angles.h"
#include "core/base/number_text.h"
#include "core/base/physical_limits.h"
#include "core/base/translated_text.h"
#include "core/scan/georef/chain.h"
#include "core/scan/georef/place_scan.h"
#include "core/scan/georef/rotations.h"
#include "core/scan/grid/acquisition.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace edgescan::robots {
namespace {

// The messages of some topics of a bag, read in one pass: a bag may have as many topics as messages.

/// Calls `visit` with topic and message for each message whose type `isWanted` accepts, in the order of the bag, and `damaged` for one that
/// cannot be read. `goOn`: false cancels; empty: never. Error: a definition is not understood, or cancelled.
template <class IsWanted, class Visit, class Damaged>
Result<Done> eachMessage(const RosBag& bag, const IsWanted& isWanted, const std::string& where, const Visit& visit, const Damaged& damaged,
                         const std::function<bool()>& goOn) {
    constexpr std::size_t kBetweenLooks = 16; // at the wish to stop
    std::vector<std::optional<RosDefinition>> definitions(bag.topics.size());
    for (std::size_t topic = 0; topic < bag.topics.size(); ++topic) {
        if (!isWanted(bag.topics[topic].type)) continue;
        auto definition = rosDefinition(bag.topics[topic].type, bag.topics[topic].definition, where);
        if (!definition) return definition.error();
        definitions[topic] = std::move(*definition);
    }
    std::size_t read = 0;
    for (const RosBagMessage& stored : bag.messages) {
        if (!definitions[stored.topic]) continue;
        if (goOn && read++ % kBetweenLooks == 0 && !goOn()) return Error{"cancelled", where, ""};
        const auto message = rosMessage(*definitions[stored.topic], bag.topics[stored.topic].encoding, stored.bytes, where);
        if (message)
            visit(stored.topic, *message);
        else
            damaged();
    }
    return Done{};
}

constexpr std::array<std::string_view, 4> kMapFrames{"mine", "map", "utm", "world"};
constexpr double kStayedM = 1e-4, kStayedTurn = 1e-5; // of an element of the rotation

bool isMap(const std::string& frame) {
    return std::ranges::find(kMapFrames, std::string_view(frame).substr(frame.rfind('/') + 1)) != kMapFrames.end();
}

/// The highest frame above `frame` with such a name; empty: there is not one.
std::string mapAbove(const FrameTree& tree, const std::string& frame) {
    std::string found;
    for (const std::string& at : tree.chain(frame)) {
        if (isMap(at)) found = at;
    }
    return found;
}

bool stayed(const std::vector<RigidTransform>& poses) {
    return std::ranges::all_of(poses, [&](const RigidTransform& pose) {
        return (pose.translationM - poses.front().translationM).norm() <= kStayedM &&
               (pose.rotation - poses.front().rotation).cwiseAbs().maxCoeff() <= kStayedTurn;
    });
}

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

Result<FrameTree> transformsIn(const RosBag& bag, const std::string& where, const std::function<bool()>& goOn) {
    const auto holdsThem = [](const std::string& type) { return type == "tf2_msgs/TFMessage" || type == "tf/tfMessage"; };
    FrameTree tree;
    const auto read = eachMessage(
        bag, holdsThem, where, [&](std::uint32_t, const RosValue& message) { tree.add(message); }, [&] { tree.addDamagedMessage(); }, goOn);
    if (!read) return read.error();
    return tree;
}

void addPoses(FrameTree& tree, const RosBag& bag, const std::string& frame, std::vector<std::string>& warnings) {
    if (!mapAbove(tree, frame).empty()) return;
    const std::string highest = tree.chain(frame).back();
    std::map<std::uint32_t, std::vector<NamedPose>> found; // by topic
    const auto addPose = [&](std::uint32_t topic, const RosValue& message) {
        const std::string map = frameNameOf(message.text("header.frame_id"));
        const auto pose = isMap(map) ? poseIn(message, "pose.position", "pose.orientation") : std::nullopt;
        if (pose) found[topic].push_back({highest, map, *pose});
    };
    const auto read = eachMessage(
        bag, [](const std::string& type) { return type == "geometry_msgs/PoseStamped"; }, "", addPose, [] {}, {});
    if (!read || found.empty()) return; // a pose is only a guess
    for (const NamedPose& pose : found.begin()->second) tree.add(pose);
    warnings.push_back(
        withValues("GUESS: the poses of the topic %1 are those of the frame %2.", {bag.topics[found.begin()->first].name, highest}));
}

void placeByFrames(Scan& scan, const FrameTree& tree, const LaserMotion& motion, std::vector<std::string>& warnings) {
    const std::string map = motion.baseFrame.empty() ? std::string() : mapAbove(tree, motion.baseFrame);
    if (map.empty() || !scan.acquisition || scan.acquisition->lineTimesS.empty()) return;
    const std::vector<std::string> up = tree.chain(motion.baseFrame);
    std::vector<RigidTransform> poses;
    for (const double seconds : scan.acquisition->lineTimesS) {
        const auto base = tree.inFrame(up, map, static_cast<std::int64_t>(seconds * 1e9));
        if (!base) return;
        poses.push_back(*base * motion.base);
        const Eigen::Vector3d& at = poses.back().translationM;
        if (!physical::kPlaceM.hold(at.x()) || !physical::kPlaceM.hold(at.y()) || !physical::kElevationM.hold(at.z())) {
            warnings.push_back(withValues(
                "The transforms put the scanner at %1, %2, %3 m, where nothing on earth is: the scan stays in the scanner's frame.",
                {significantText(at.x(), 6), significantText(at.y(), 6), significantText(at.z(), 6)}));
            return;
        }
    }
    if (stayed(poses)) poses.resize(1);
    auto placement = std::make_shared<Placement>();
    placement->mount = motion.mount;
    placement->originEnhM = chooseOrigin(poses.front().translationM);
    for (RigidTransform& pose : poses) pose.translationM -= placement->originEnhM;
    placement->poses = std::move(poses);
    placement->grid = withValues("the frame %1 of the bag", {map});
    placement->source = "the transforms of the bag";
    placement->ageSeconds = std::numeric_limits<double>::quiet_NaN();
    placement->warnings = {
        withValues("GUESS: the frame %1 of the bag is taken as the mine grid, with x to the east, y to the north and z up.", {map})};
    judgeSpeed(*placement, scan.acquisition->lineTimesS);
    scan.placement = std::move(placement);
}

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
