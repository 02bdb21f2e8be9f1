// Map frame from axis base, for each line.
#include "core/robots/sweeps/bag_place.h"
#include "core/base/translated_text.h"

#include "core/base/number_text.h"
#include "core/base/physical_limits.h"
#include "core/robots/sweeps/each_message.h"
#include "core/scan/georef/chain.h"
#include "core/scan/georef/place_scan.h"
#include "core/scan/grid/acquisition.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>

namespace edgescan::robots {
namespace {

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

} // namespace edgescan::robots
