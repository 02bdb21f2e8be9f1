// Scans of a ROS bag: a sweep from the lines of a laser that is turned, or a cloud.
#pragma once

#include "core/files/point_tables/point_table.h"
#include "core/robots/sweeps/bag_topics.h"
#include "core/scan/grid/scan.h"

namespace edgescan::robots {

/// The sweep with most lines of a topic of lines, or sweep ReadingOptions::scanIndex if it is given, through the same assembly as a live
/// scanner's lines. The angle of a line comes from transforms, else from a joint, else from --line-step. Warnings name what was chosen,
/// guessed, lost and left out. Error: no angle is known, no line is there.
Result<Scan> sweepOfBag(const RosBag& bag, const BagTopic& topic, const files::Source& source);

/// The points of one message of a topic of clouds: that with most of them, or message ReadingOptions::scanIndex if it is given.
Result<files::PointTable> cloudOfBag(const RosBag& bag, const BagTopic& topic, const files::Source& source);

} // namespace edgescan::robots
