// ROS bags in any container.
#pragma once

#include "core/containers/mcap/reader.h"
#include "core/files/formats/format.h"
#include "core/files/recording/recorded_source.h"
#include "core/robots/sweeps/bag_listing.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace edgescan::robots {

/// As Addon::recorded.
Result<std::unique_ptr<files::RecordedSource>> recordedBag(const containers::McapContent& content, const std::string& where,
                                                           const std::function<bool()>& goOn);

/// The row of the table of formats.
files::Format rosBagFormat();

/// The scan of the ROS topics of an MCAP file; empty: it holds none.
std::optional<Result<files::Reading>> readRosMcap(const files::Source& source);

/// The topics of a bag. Empty: it is none. Error: it cannot be read.
std::optional<Result<BagListing>> bagListing(const files::Source& source);

/// A part of a bag that was split.
struct BagPart {
    std::filesystem::path path;       ///< of its file
    std::span<const std::byte> bytes; ///< not packed
};

/// The scan of all parts, whatever container each is; `whole` has the options and the path. A part that cannot be read is left out with a
/// warning that names it. Error: there is no scan in them.
Result<files::Reading> readBagParts(const std::vector<BagPart>& parts, const files::Source& whole);
/// Their topics.
Result<BagListing> listingOfParts(const std::vector<BagPart>& parts, const files::Source& whole);

} // namespace edgescan::robots
