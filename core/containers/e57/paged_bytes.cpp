// Pages and their checksums.
#include "core/containers/e57/paged_bytes.h"
#include "core/base/translated_text.h"

#include <algorithm>
#include <array>

namespace edgescan::containers {
namespace {

using CrcTables = std::array<std::array<std::uint32_t, 256>, 8>;

/// Table n holds the effect of a byte that n bytes follow: eight bytes are taken in one go.
constexpr CrcTables crcTables() {
    constexpr std::uint32_t kPolynomial = 0x82F63B78; // Castagnoli, the lowest bit first
    CrcTables tables{};
    for (std::uint32_t byte = 0; byte < 256; ++byte) {
        std::uint32_t crc = byte;
        for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1U) ^ ((crc & 1U) != 0 ? kPolynomial : 0U);
        tables[0][byte] = crc;
    }
    for (std::size_t n = 1; n < tables.size(); ++n) {
        for (std::size_t byte = 0; byte < 256; ++byte) {
            const std::uint32_t before = tables[n - 1][byte];
            tables[n][byte] = (before >> 8U) ^ tables[0][before & 0xFFU];
        }
    }
    return tables;
}

} // namespace

std::uint32_t crc32c(std::span<const std::byte> bytes) {
    static constexpr CrcTables kTables = crcTables();
    const auto at = [&](std::size_t i) { return std::to_integer<std::uint32_t>(bytes[i]); };
    std::uint32_t crc = 0xFFFFFFFF;
    std::size_t i = 0;
    for (; i + 8 <= bytes.size(); i += 8) {
        crc ^= at(i) | at(i + 1) << 8U | at(i + 2) << 16U | at(i + 3) << 24U;
        crc = kTables[7][crc & 0xFFU] ^ kTables[6][(crc >> 8U) & 0xFFU] ^ kTables[5][(crc >> 16U) & 0xFFU] ^ kTables[4][crc >> 24U] ^
              kTables[3][at(i + 4)] ^ kTables[2][at(i + 5)] ^ kTables[1][at(i + 6)] ^ kTables[0][at(i + 7)];
    }
    for (; i < bytes.size(); ++i) crc = (crc >> 8U) ^ kTables[0][(crc ^ at(i)) & 0xFFU];
    return ~crc;
}

PagedBytes::PagedBytes(std::span<const std::byte> file, std::uint64_t pageBytes, std::string where)
    : file_(file), pageBytes_(pageBytes), pages_(file.size() / pageBytes), checked_(pages_, false), where_(std::move(where)) {}

std::optional<std::uint64_t> PagedBytes::logical(std::uint64_t physical) const {
    const std::uint64_t page = physical / pageBytes_;
    const std::uint64_t inPage = physical % pageBytes_;
    if (page >= pages_ || inPage >= content()) return std::nullopt;
    return page * content() + inPage;
}

std::uint64_t PagedBytes::physical(std::uint64_t logical) const { return logical / content() * pageBytes_ + logical % content(); }

Result<Done> PagedBytes::check(std::uint64_t page) {
    if (checked_[page]) return Done{};
    const auto bytes = file_.subspan(page * pageBytes_, pageBytes_);
    std::uint32_t stored = 0; // the highest byte first, unlike all else in the file
    for (const std::byte byte : bytes.last(kChecksum)) stored = stored << 8U | std::to_integer<std::uint32_t>(byte);
    if (crc32c(bytes.first(content())) != stored) {
        return Error{withValues("page %1 of %2 of this E57 file is damaged: its checksum does not fit", {page + 1, pages_}),
                     withValues("%1: byte %2", {where_, page * pageBytes_}), "copy the file again"};
    }
    checked_[page] = true;
    return Done{};
}

Result<Done> PagedBytes::read(std::uint64_t logical, std::uint64_t bytes, std::vector<std::byte>& to) {
    if (logical > size() || bytes > size() - logical)
        return Error{"this E57 file ends before something that it names", where_, "copy the file again, it may be cut off"};
    while (bytes > 0) {
        const std::uint64_t page = logical / content();
        if (auto good = check(page); !good) return good;
        const std::uint64_t inPage = logical % content();
        const std::uint64_t count = std::min(bytes, content() - inPage);
        const auto part = file_.subspan(page * pageBytes_ + inPage, count);
        to.insert(to.end(), part.begin(), part.end());
        logical += count;
        bytes -= count;
    }
    return Done{};
}

} // namespace edgescan::containers
