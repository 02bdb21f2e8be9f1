// A file in pages that each end with a checksum of their own (ASTM E2807, "physical" and "logical" places in a file).
#pragma once

#include "core/base/result.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace edgescan::containers {

/// CRC-32C (Castagnoli) of these bytes.
[[nodiscard]] std::uint32_t crc32c(std::span<const std::byte> bytes);

/// The bytes of the pages without their checksums, one after the other. Each page is checked when it is first read, so that damage
/// elsewhere in the file costs nothing.
class PagedBytes {
public:
    /// `pageBytes`: with the checksum, at least 5. A last page that is not whole does not count.
    PagedBytes(std::span<const std::byte> file, std::uint64_t pageBytes, std::string where);

    /// Bytes without checksums.
    [[nodiscard]] std::uint64_t size() const { return pages_ * content(); }
    /// The place of a byte of the file without checksums; empty when it is not in the file, or part of a checksum.
    [[nodiscard]] std::optional<std::uint64_t> logical(std::uint64_t physical) const;
    /// The other way round, for messages.
    [[nodiscard]] std::uint64_t physical(std::uint64_t logical) const;

    /// Appends bytes to `to`. Error: there are not so many, or a page of them is damaged; it names the page.
    Result<Done> read(std::uint64_t logical, std::uint64_t bytes, std::vector<std::byte>& to);

    [[nodiscard]] const std::string& where() const { return where_; }

private:
    static constexpr std::uint64_t kChecksum = 4;

    [[nodiscard]] std::uint64_t content() const { return pageBytes_ - kChecksum; }
    Result<Done> check(std::uint64_t page);

    std::span<const std::byte> file_;
    std::uint64_t pageBytes_;
    std::uint64_t pages_;
    std::vector<bool> checked_; // per page
    std::string where_;
};

} // namespace edgescan::containers
