// The bytes of a file, which cannot change while EdgeScan uses them.
#pragma once

#include "core/base/result.h"

#include <cstddef>
#include <filesystem>
#include <span>
#include <utility>
#include <vector>

namespace edgescan {

/// All bytes of a regular file as they were when it was opened. Large files are mapped instead of copied if the system can block writers
/// until this object ends (a lease; for files of this user on a file system of this machine). All other files are read into memory.
class HeldFile {
public:
    explicit HeldFile(std::vector<std::byte> bytes) : copy_(std::move(bytes)) {}
    HeldFile(HeldFile&& other) noexcept
        : copy_(std::move(other.copy_)), mapped_(std::exchange(other.mapped_, {})), lease_(std::exchange(other.lease_, -1)) {}
    HeldFile& operator=(HeldFile&&) = delete;
    HeldFile(const HeldFile&) = delete;
    HeldFile& operator=(const HeldFile&) = delete;
    ~HeldFile();

    [[nodiscard]] std::span<const std::byte> bytes() const { return lease_ < 0 ? std::span(copy_) : mapped_; }
    [[nodiscard]] bool isMapped() const { return lease_ >= 0; }

private:
    friend Result<HeldFile> holdFile(const std::filesystem::path& path);
    HeldFile(std::span<const std::byte> mapped, int lease) : mapped_(mapped), lease_(lease) {}

    std::vector<std::byte> copy_;
    std::span<const std::byte> mapped_;
    int lease_ = -1; ///< descriptor that holds the lease; -1: none
};

/// Errors as those of readWholeFile().
Result<HeldFile> holdFile(const std::filesystem::path& path);

} // namespace edgescan
