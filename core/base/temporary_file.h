// A complete file under a temporary name, in the folder of the file that it becomes.
#pragma once

#include "core/base/descriptor.h"
#include "core/base/result.h"

#include <cstddef>
#include <filesystem>
#include <span>

namespace edgescan {

/// The sentence for the system's error number of a failed write of `path`.
[[nodiscard]] Error writeError(const std::filesystem::path& path, int code);

/// Whether the open file is the one that `path` names now.
[[nodiscard]] bool isOpenAt(int file, const std::filesystem::path& path);

/// Exists under the name .edgescan-HOST-PROCESS-NUMBER.part until it is renamed or this object ends. A lock on it, held until then, shows
/// that its program is running: the next program that writes into the folder on the same machine removes files whose program was killed.
class TemporaryFile {
public:
    /// Writes all bytes, waits until they are on the disk and reads them back. `asked` is the path for messages. The mode is that of `like`
    /// where it is there, else that of the file that is replaced, else that of the umask.
    static Result<TemporaryFile> write(const std::filesystem::path& asked, const std::filesystem::path& target,
                                       std::span<const std::byte> bytes, const std::filesystem::path& like);
    TemporaryFile(TemporaryFile&& other) noexcept
        : file_(std::move(other.file_)), path_(std::move(other.path_)), target_(std::move(other.target_)),
          renamed_(std::exchange(other.renamed_, true)) {}
    TemporaryFile& operator=(TemporaryFile&&) = delete;
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    ~TemporaryFile();

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    [[nodiscard]] const std::filesystem::path& target() const { return target_; }
    /// The file has its target's name now: this object no longer removes it, and its lock ends.
    void wasRenamed() {
        renamed_ = true;
        file_ = Descriptor();
    }

private:
    TemporaryFile(Descriptor file, std::filesystem::path path, std::filesystem::path target)
        : file_(std::move(file)), path_(std::move(path)), target_(std::move(target)) {}

    Descriptor file_;
    std::filesystem::path path_, target_;
    bool renamed_ = false;
};

} // namespace edgescan
