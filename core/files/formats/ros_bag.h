// ROS bags in any container.
#pragma once

#include "core/containers/mcap/reader.h"
#include "core/files/formats/reading.h"
#include "core/files/ros/bag_listing.h"

#include <optional>

namespace edgescan::files {

/// The scan of the ROS topics of a recording.
Result<Reading> readRosMcap(const containers::McapContent& content, const Source& source);

/// The topics of a bag. Empty: it is none. Error: it cannot be read.
std::optional<Result<BagListing>> bagListing(const Source& source);

} // namespace edgescan::files
