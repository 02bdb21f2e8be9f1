// ROS bags in any container.
#pragma once

#include "core/containers/mcap/reader.h"
#include "core/files/formats/reading.h"
#include "core/files/ros/bag_listing.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace edgescan::files {

/// The scan of the ROS topics of a recording.
Result<Reading> readRosMcap(const containers::McapContent& content, const Source& source);

/// The topics of a bag. Empty: it is none. Error: it cannot be read.
std::optional<Result<BagListing>> bagListing(const Source& source);

/// A part of a bag that was split.
struct BagPart {
    std::filesystem::path path;       ///< of its file
    std::span<const std::byte> bytes; ///< not packed
};

/// The scan of all parts, whatever container each is; `whole` has the options and the path. A part that cannot be read is left out with a
/// warning that names it. Error: there is no scan in them.
Result<Reading> readBagParts(const std::vector<BagPart>& parts, const Source& whole);
/// Their topics.
Result<BagListing> listingOfParts(const std::vector<BagPart>& parts, const Source& whole);

} // namespace edgescan::files
