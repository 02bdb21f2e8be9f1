// A bag played line by line, as a recording of a scanner.
#pragma once

#include "core/containers/mcap/reader.h"
#include "core/files/recording/recorded_source.h"

#include <functional>

namespace edgescan::robots {

/// As Addon::recorded.
Result<std::unique_ptr<files::RecordedSource>> recordedBag(const containers::McapContent& content, const std::string& where,
                                                           const std::function<bool()>& goOn);

} // namespace edgescan::robots
