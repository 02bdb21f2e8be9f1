// Map frame from axis base, for each line.
#include "core/files/ros/bag_place.h"

#include "core/base/number_text.h"
#include "core/base/physical_limits.h"
#include "core/scan/georef/chain.h"
#include "core/scan/grid/acquisition.h"

#include <algorithm>
#include <array>
#include <limits>

namespace edgescan::files {
namespace {

constexpr std::array<std::string_view, 4> kMapFrames{"mine", "map", "utm", "world"};
constexpr double kStayedM = 1e-4, kStayedTurn = 1e-5; // of an element of the rotation

/// The highest frame above `frame` with such a name; empty: there is not one.
std::string mapAbove(const FrameTree& tree, const std::string& frame) {
    std::string found;
    for (const std::string& at : tree.chain(frame)) {
        const std::string_view last = std::string_view(at).substr(at.rfind('/') + 1);
        if (std::ranges::find(kMapFrames, last) != kMapFrames.end()) found = at;
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

void placeByFrames(Scan& scan, const FrameTree& tree, const LaserMotion& motion, std::vector<std::string>& warnings) {
    const std::string map = motion.baseFrame.empty() ? std::string() : mapAbove(tree, motion.baseFrame);
    if (map.empty() || !scan.acquisition || scan.acquisition->lineTimesS.empty()) return;
    std::vector<RigidTransform> poses;
    for (const double seconds : scan.acquisition->lineTimesS) {
        const auto base = tree.inFrame(motion.baseFrame, map, static_cast<std::int64_t>(seconds * 1e9));
        if (!base) return;
        poses.push_back(*base * motion.base);
        const Eigen::Vector3d& at = poses.back().translationM;
        if (!physical::kPlaceM.hold(at.x()) || !physical::kPlaceM.hold(at.y()) || !physical::kElevationM.hold(at.z())) {
            warnings.push_back("The transforms put the scanner at " + significantText(at.x(), 6) + ", " + significantText(at.y(), 6) +
                               ", " + significantText(at.z(), 6) + " m, where nothing on earth is: the scan stays in the scanner's frame.");
            return;
        }
    }
    if (stayed(poses)) poses.resize(1);
    auto placement = std::make_shared<Placement>();
    placement->mount = motion.mount;
    placement->originEnhM = chooseOrigin(poses.front().translationM);
    for (RigidTransform& pose : poses) pose.translationM -= placement->originEnhM;
    placement->poses = std::move(poses);
    placement->grid = "the frame " + map + " of the bag";
    placement->source = "the transforms of the bag";
    placement->ageSeconds = std::numeric_limits<double>::quiet_NaN();
    placement->warnings = {"GUESS: the frame " + map +
                           " of the bag is taken as the mine grid, with x to the east, y to the north and z up."};
    warnings.push_back(placement->warnings.front());
    scan.placement = std::move(placement);
}

} // namespace edgescan::files
