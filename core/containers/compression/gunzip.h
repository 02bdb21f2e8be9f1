// gzip files (RFC 1952).
#pragma once

#include "core/containers/compression/inflate.h"

namespace edgescan::containers {

[[nodiscard]] bool isGzip(std::span<const std::byte> bytes);

/// All members one behind the other, as gunzip gives them; zeros behind the last one are padding. Error: as inflateOne(), or something
/// else behind the last member.
Result<std::vector<std::byte>> gunzip(std::span<const std::byte> bytes, const std::string& where, const std::function<bool(double)>& goOn);

} // namespace edgescan::containers
