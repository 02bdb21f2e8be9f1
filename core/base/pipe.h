// Reads all bytes of a pipe or of standard input.
#pragma once

#include "core/base/result.h"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <vector>

namespace edgescan {

/// This means standard input where a path is expected; a file of that name is "./-".
inline constexpr const char* kStandardInput = "-";

/// True for "-" and for named pipes. False for devices: many of them have no end.
[[nodiscard]] bool isPipe(const std::filesystem::path& path);

/// All bytes up to the end. `goOn` is called several times a second; false cancels. Error: cancelled, a keyboard or another device, no
/// program writes to the pipe, more bytes than the memory available.
Result<std::vector<std::byte>> readPipe(const std::filesystem::path& path, const std::function<bool()>& goOn);

} // namespace edgescan
