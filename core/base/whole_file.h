// A file is written completely or not at all: a temporary file in the same folder, fsync, rename.
#pragma once

#include "core/base/result.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
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

/// Writes the file: a temporary file is written, synced and read back before it takes the name. On an Error (no such folder, not allowed,
/// disk full ...) the old file is unchanged and no temporary file remains. Several programs may write the same file: each content appears
/// whole, and the last one stays. A file that was read as an input is never replaced (core/base/inputs.h), nor is a read-only file, nor
/// JSON of EdgeScan by a file of another kind (core/base/own_kind.h). A link is followed unless it belongs to a user other than this one
/// and root. A device or pipe (/dev/stdout) is written to directly; a program must open the pipe for reading within seconds and read all of
/// it within half a minute. New files get the mode of the umask.
Result<Done> writeWholeFile(const std::filesystem::path& path, std::span<const std::byte> bytes);
Result<Done> writeWholeFile(const std::filesystem::path& path, const std::string& text);

/// The same errors before the work on the content begins, where they are known without it.
Result<Done> checkCanBeWritten(const std::filesystem::path& path);

/// The file that a path leads to through its links; it need not exist. Error: a folder, a circle, a link of another user.
Result<std::filesystem::path> finalTarget(const std::filesystem::path& path);

/// True for "-", and for "-.EXT" where the extension chooses a format: standard output. Valid for every file that EdgeScan writes.
[[nodiscard]] bool isStandardOutput(const std::filesystem::path& path);

/// Whether the target is not a regular file but standard output, a device or a pipe. It cannot be read back.
[[nodiscard]] bool isDevice(const std::filesystem::path& path);

/// Writes files that belong together: all temporary files are complete on the disk before the first one is renamed. The order is that of
/// the list. A lock on the folder keeps together what several programs write at the same time. A kill between two renames leaves files that
/// do not belong together: a record contains the SHA-256 of its file.
Result<Done> writeWholeFiles(const std::vector<FileContent>& files);

/// Gets the text of a file, or nullopt if the file does not exist, and returns its new text; nullopt removes the file.
using FileChange = std::function<Result<std::optional<std::string>>(const std::optional<std::string>& text)>;

/// Reads a file and writes what `change` makes of it. Two programs that do this wait for each other, so none loses the other's changes.
/// Error: as readWholeFile(), of `change`, as writeWholeFile().
Result<Done> changeWholeFile(const std::filesystem::path& path, std::uint64_t most, const FileChange& change);

/// writeWholeFile() for a sidecar that EdgeScan wrote itself: this one may be an input of the scan that is open.
Result<Done> replaceOwnSidecar(const std::filesystem::path& path, const std::string& text);

/// Makes the folder, and those above it, unless they are there. Without a name there is nothing to make.
Result<Done> makeFolder(const std::filesystem::path& folder, const char* remedy = "choose one that can be written to");

/// A complete file and its place in the same file system.
struct FileMove {
    std::filesystem::path from, to;
};

/// Moves complete files to their places; inputs and read-only files are not replaced. A link in such a place is replaced, not followed.
Result<Done> moveWholeFiles(const std::vector<FileMove>& moves);

/// All bytes of a regular file. Error: missing, a folder, not allowed, more than `most` bytes or the memory available ...
Result<std::vector<std::byte>> readWholeFile(const std::filesystem::path& path, std::uint64_t most = UINT64_MAX);

/// The bytes as text. `bytes` must outlive the view.
[[nodiscard]] inline std::string_view textOf(std::span<const std::byte> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

} // namespace edgescan
