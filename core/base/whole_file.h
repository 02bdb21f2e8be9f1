// A file is written completely or not at all: a temporary file in the same folder, fsync, rename.
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

/// The content of one file to write.
struct FileContent {
    std::filesystem::path path;
    std::span<const std::byte> bytes;
};

/// Writes the file. On an Error (no such folder, not allowed, disk full ...) the old file is unchanged and no temporary file remains. A
/// file that was read as an input is never replaced (core/base/inputs.h). A link is followed unless it belongs to a user other than this
/// one and root. A device or pipe (/dev/stdout) is written to directly; a program must open the pipe for reading within seconds and read
/// all of it within half a minute. New files get the mode of the umask.
Result<Done> writeWholeFile(const std::filesystem::path& path, std::span<const std::byte> bytes);
Result<Done> writeWholeFile(const std::filesystem::path& path, const std::string& text);

/// True for "-", and for "-.EXT" where the extension chooses a format: standard output. Valid for every file that EdgeScan writes.
[[nodiscard]] bool isStandardOutput(const std::filesystem::path& path);

/// Whether the target is not a regular file but standard output, a device or a pipe. It cannot be read back.
[[nodiscard]] bool isDevice(const std::filesystem::path& path);

/// Writes files that belong together: all temporary files are complete on the disk before the first one is renamed. The order is that of
/// the list.
Result<Done> writeWholeFiles(const std::vector<FileContent>& files);

/// All bytes of a regular file. Error: missing, a folder, not allowed, more than `most` bytes or the memory available ...
Result<std::vector<std::byte>> readWholeFile(const std::filesystem::path& path, std::uint64_t most = UINT64_MAX);

/// The bytes as text. `bytes` must outlive the view.
[[nodiscard]] inline std::string_view textOf(std::span<const std::byte> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

} // namespace edgescan
