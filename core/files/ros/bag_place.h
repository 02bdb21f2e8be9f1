// The place of a sweep in the mine, by the transforms of its bag.
#pragma once

#include "core/files/ros/frames.h"
#include "core/files/ros/laser_motion.h"
#include "core/scan/grid/scan.h"

#include <string>
#include <vector>

namespace edgescan::files {

/// Gives the scan its place where a frame of a map is above the laser: map, mine, utm or world, also behind a namespace. One pose if that
/// frame stayed, else one for each line. Its axes are east, north and up (REP 105); a warning says that it is a guess.
void placeByFrames(Scan& scan, const FrameTree& tree, const LaserMotion& motion, std::vector<std::string>& warnings);

} // namespace edgescan::files
