// The place of a sweep in the mine, by the transforms of its bag.
#pragma once

#include "core/robots/bags/bag.h"
#include "core/robots/sweeps/frames.h"
#include "core/robots/sweeps/laser_motion.h"
#include "core/scan/grid/scan.h"

#include <functional>
#include <string>
#include <vector>

namespace edgescan::robots {

/// All transforms of the bag; call FrameTree::finish() before it is used. Error: their definition is not understood, or cancelled.
Result<FrameTree> transformsIn(const RosBag& bag, const std::string& where, const std::function<bool()>& goOn);

/// Where no frame of a map is above `frame`, but the bag has geometry_msgs/PoseStamped in one: they become the transforms of the highest
/// frame above it. A warning says that it is a guess. Call it before FrameTree::finish().
void addPoses(FrameTree& tree, const RosBag& bag, const std::string& frame, std::vector<std::string>& warnings);

/// Gives the scan its place where a frame of a map is above the laser: map, mine, utm or world, also behind a namespace. One pose if that
/// frame stayed, else one for each line. Its axes are east, north and up (REP 105); a warning says that it is a guess.
void placeByFrames(Scan& scan, const FrameTree& tree, const LaserMotion& motion, std::vector<std::string>& warnings);

} // namespace edgescan::robots
