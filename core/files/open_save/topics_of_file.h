// The topics of a file that is a ROS bag, for `info` and for people who choose one.
#pragma once

#include "core/base/result.h"
#include "core/files/ros/bag_listing.h"

#include <filesystem>
#include <optional>

namespace edgescan::files {

/// Of the options only `progress` counts. Empty: the file is not a bag, or cannot be read at all. Error: the bag cannot be read.
std::optional<Result<BagListing>> topicsOfFile(const std::filesystem::path& path, const ReadingOptions& options = {});

} // namespace edgescan::files
