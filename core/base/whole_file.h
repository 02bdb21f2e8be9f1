// Files appear whole or not at all: a temporary in the same folder, fsync, rename.
#pragma once

#include "core/base/result.h"

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace edgescan {

/// What one file shall hold.
struct FileContent {
    std::filesystem::path path;
    std::span<const std::byte> bytes;
};

/// Writes the file. On an Error (no such folder, not allowed, disk full ...) the old file is as it was and no temporary is left.
/// A link is followed; a device or pipe (/dev/stdout) is written to directly.
Result<Done> writeWholeFile(const std::filesystem::path& path, std::span<const std::byte> bytes);
Result<Done> writeWholeFile(const std::filesystem::path& path, const std::string& text);

/// Writes files that belong together: all temporaries are complete on the disk before the first is renamed, in the order given.
Result<Done> writeWholeFiles(const std::vector<FileContent>& files);

/// All bytes of a regular file. Error: missing, a folder, not allowed, more than the memory available ...
Result<std::vector<std::byte>> readWholeFile(const std::filesystem::path& path);

} // namespace edgescan
