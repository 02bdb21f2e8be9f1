// Files appear whole or not at all: a temporary in the same folder, fsync, rename.
#pragma once

#include "core/base/result.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace edgescan {

/// What one file shall hold.
struct FileContent {
    std::filesystem::path path;
    std::span<const std::byte> bytes;
};

/// Writes the file. On an Error (no such folder, not allowed, disk full ...) the old file is as it was and no temporary is left.
/// A file that was read as an input is never replaced (core/base/inputs.h). A link is followed unless it belongs to another user than this
/// one and root. A device or pipe (/dev/stdout) is written to directly; a pipe must have a reader within seconds and be read within half a
/// minute. New files have the mode that the umask leaves.
Result<Done> writeWholeFile(const std::filesystem::path& path, std::span<const std::byte> bytes);
Result<Done> writeWholeFile(const std::filesystem::path& path, const std::string& text);

/// "-", or "-.EXT" where the extension chooses a format: standard output, for every file that is written.
[[nodiscard]] bool isStandardOutput(const std::filesystem::path& path);

/// Whether what is written there is no regular file: standard output, a device, a pipe. It cannot be read again.
[[nodiscard]] bool isDevice(const std::filesystem::path& path);

/// Writes files that belong together: all temporaries are complete on the disk before the first is renamed, in the order given.
Result<Done> writeWholeFiles(const std::vector<FileContent>& files);

/// All bytes of a regular file. Error: missing, a folder, not allowed, more than `most` bytes or the memory available ...
Result<std::vector<std::byte>> readWholeFile(const std::filesystem::path& path, std::uint64_t most = UINT64_MAX);

/// The bytes as text. Must outlive the view: `bytes`.
[[nodiscard]] inline std::string_view textOf(std::span<const std::byte> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

} // namespace edgescan
