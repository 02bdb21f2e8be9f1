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

/// By point: the number of its firing. A firing is one shot of all beams; each beam may have its own delay in it. `times`: of the points,
/// in any unit. Points that were not measured leave gaps. Empty: the times show no firings.
std::optional<std::vector<std::uint32_t>> firingsOf(std::span<const std::uint32_t> rings, std::span<const double> times);

} // namespace edgescan::robots
