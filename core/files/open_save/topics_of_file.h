// The topics of a file that has some, for `info` and for people who choose one.
#pragma once

#include "core/files/addons/addon.h"
#include "core/scan/grid/reading_options.h"

namespace edgescan::files {

/// Of the options only `progress` counts. Empty: the file has no topics, or cannot be read at all. Error: the bag cannot be read.
inline std::optional<Result<BagListing>> topicsOfFile(const std::filesystem::path& path, const ReadingOptions& options = {}) {
    return addon().topicsOf == nullptr ? std::nullopt : addon().topicsOf(path, options);
}

} // namespace edgescan::files
