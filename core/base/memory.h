// The available memory, checked before EdgeScan allocates what a file's header announces.
#pragma once

#include "core/base/result.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace edgescan {

/// Bytes that can be allocated without swapping and without being killed: the smallest of MemAvailable, the rest in the control groups of
/// this process, and the rest of its address space (ulimit -v).
[[nodiscard]] std::uint64_t availableMemoryBytes();

/// Bytes left in the control groups: in the group of the process and in each group above it; the lowest limit holds. `groups` is the text
/// of /proc/self/cgroup, `mount` the folder /sys/fs/cgroup. The largest number if there is no limit.
[[nodiscard]] std::uint64_t memoryLeftInGroups(std::string_view groups, const std::filesystem::path& mount);

/// Error if `neededBytes` is 1 MB or more and exceeds the available memory: "needs 3.1 GB of memory, 2.2 GB are free". `where` is the path
/// of the file that needs it.
Result<Done> checkMemory(std::uint64_t neededBytes, const std::string& where);

/// "3.1 GB", "162.7 kB", "12 bytes"; decimal prefixes.
[[nodiscard]] std::string sizeText(std::uint64_t bytes);

} // namespace edgescan
