// Inflating in steps, with a bound on what may come out.
#pragma once

#include "core/base/result.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace edgescan::containers {

enum class Packing : std::uint8_t { Gzip, Deflate }; ///< with gzip's header and check, or as ZIP archives hold it

/// One stream from the front of `packed`, appended to `to`; gives the packed bytes used. `most` bytes may be in `to`. `goOn` gets how
/// much is used (0..1) and cancels with false. Error: damaged, cut off, too much, cancelled.
Result<std::size_t> inflateOne(std::span<const std::byte> packed, Packing packing, std::uint64_t most, std::vector<std::byte>& to,
                               const std::string& where, const std::function<bool(double)>& goOn);

} // namespace edgescan::containers
