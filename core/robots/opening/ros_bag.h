// ROS bags in any container, also in several files, and played line by line.
#pragma once

#include "core/containers/mcap/reader.h"
#include "core/files/formats/format.h"
#include "core/files/recording/recorded_source.h"
#include "core/robots/sweeps/bag_folder.h"
#include "core/robots/sweeps/bag_topics.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace edgescan::robots {

/// The row of the table of formats.
files::Format rosBagFormat();

/// The scan of the ROS topics of an MCAP file; empty: it holds none.
std::optional<Result<files::Reading>> readRosMcap(const files::Source& source);

/// As Addon::openSeveral and Addon::topicsOf.
std::optional<Result<Scan>> openSplitBag(std::filesystem::path& path, const ReadingOptions& options, const files::LinePlayed& played);
std::optional<Result<files::BagListing>> topicsOfBag(const std::filesystem::path& path, const ReadingOptions& options);

/// As Addon::recorded.
Result<std::unique_ptr<files::RecordedSource>> recordedBag(const containers::McapContent& content, const std::string& where,
                                                           const std::function<bool()>& goOn);

} // namespace edgescan::robots
