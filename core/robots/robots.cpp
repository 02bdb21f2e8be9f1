// Robots: ROS bags, the Foxglove bridge, VLP-16 and Ouster. This file alone joins the group to the program.
#include "core/files/addons/addon.h"
#include "core/robots/live/robot_source.h"
#include "core/robots/opening/ros_bag.h"
#include "core/robots/spinning/spinning_capture.h"

namespace edgescan::robots {
namespace {

const files::RegisteredAddon kRobots{{.formats = [] { return std::vector{rosBagFormat()}; },
                                      .readMcap = readRosMcap,
                                      .readPackets = spinningScanIn,
                                      .openSeveral = openSplitBag,
                                      .partOf = partOfBag,
                                      .topicsOf = topicsOfBag,
                                      .recorded = recordedBag,
                                      .live = liveRobot}};

} // namespace
} // namespace edgescan::robots
