// All that comes out of a pipe or standard input.
#pragma once

#include "core/base/result.h"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <vector>

namespace edgescan {

/// What stands for standard input where a path is expected; a file of that name is "./-".
inline constexpr const char* kStandardInput = "-";

/// True for "-" and for named pipes. Devices are none: many have no end.
[[nodiscard]] bool isPipe(const std::filesystem::path& path);

/// Everything up to the end. `goOn` is asked several times a second and cancels with false. Error: cancelled, a keyboard or another device,
/// nobody writes, more than the memory available.
Result<std::vector<std::byte>> readPipe(const std::filesystem::path& path, const std::function<bool()>& goOn);

} // namespace edgescan
