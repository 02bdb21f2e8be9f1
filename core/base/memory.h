// How much memory there is, asked before allocating what a file's header promises.
#pragma once

#include "core/base/result.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace edgescan {

/// Bytes that can be allocated without swapping or being killed: the least of MemAvailable, what the control groups around this process
/// still allow, and what is left of its address space (ulimit -v).
[[nodiscard]] std::uint64_t availableMemoryBytes();

/// What the control groups still allow, each one on the way up from the process's own: a limit of any of them holds. `groups` is the text
/// of /proc/self/cgroup, `mount` the folder /sys/fs/cgroup. The largest number there is where nothing is limited.
[[nodiscard]] std::uint64_t memoryLeftInGroups(std::string_view groups, const std::filesystem::path& mount);

/// Error when `neededBytes`, from 1 MB on, is more than is available: "needs 3.1 GB of memory, 2.2 GB are free". `where` is the path it is
/// needed for.
Result<Done> checkMemory(std::uint64_t neededBytes, const std::string& where);

/// "3.1 GB", "162.7 kB", "12 bytes"; decimal prefixes.
[[nodiscard]] std::string sizeText(std::uint64_t bytes);

} // namespace edgescan
