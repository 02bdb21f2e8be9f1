// How much memory there is, asked before allocating what a file's header promises.
#pragma once

#include "core/base/result.h"

#include <cstdint>
#include <string>

namespace edgescan {

/// Bytes that can be allocated without swapping or being killed: MemAvailable, or what the control group still allows if less.
[[nodiscard]] std::uint64_t availableMemoryBytes();

/// Error when `neededBytes` is more than is available: "needs 3.1 GB of memory, 2.2 GB are free". `where` is the path it is needed for.
Result<Done> checkMemory(std::uint64_t neededBytes, const std::string& where);

/// "3.1 GB", "162.7 kB", "12 bytes"; decimal prefixes.
[[nodiscard]] std::string sizeText(std::uint64_t bytes);

} // namespace edgescan
