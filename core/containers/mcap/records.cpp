// Little-endian bytes and their checksum.
#include "core/containers/mcap/records.h"

#include <zlib.h>

#include <cstring>

namespace edgescan::containers {

void McapBytes::append(std::uint64_t v, unsigned count) {
    for (unsigned i = 0; i < count; ++i) bytes_.push_back(static_cast<std::uint8_t>(v >> (8 * i)));
}

void McapBytes::put(const void* from, std::size_t count) {
    if (count == 0) return;
    const std::size_t start = bytes_.size();
    bytes_.resize(start + count);
    std::memcpy(bytes_.data() + start, from, count);
}

std::uint32_t crc32(ByteView bytes) { return static_cast<std::uint32_t>(::crc32_z(0, bytes.data(), bytes.size())); }

namespace {
constexpr std::size_t kSumEvery = 1024;
std::uint32_t crcOnward(std::uint32_t before, ByteView bytes) {
    return static_cast<std::uint32_t>(::crc32_z(before, bytes.data(), bytes.size()));
}
} // namespace

PartChecksums::PartChecksums(ByteView bytes) : bytes_(bytes), kept_{0} {
    for (std::size_t at = 0; at + kSumEvery <= bytes.size(); at += kSumEvery)
        kept_.push_back(crcOnward(kept_.back(), bytes.subspan(at, kSumEvery)));
}

std::uint32_t PartChecksums::upTo(std::size_t end) const {
    const std::size_t piece = end / kSumEvery;
    return crcOnward(kept_[piece], bytes_.subspan(piece * kSumEvery, end % kSumEvery));
}

std::uint32_t PartChecksums::of(std::size_t from, std::size_t count) const {
    if (count <= 4 * kSumEvery) return crc32(bytes_.subspan(from, count));
    // The sum over A B is that of A moved on by the length of B, and that of B.
    return upTo(from + count) ^ static_cast<std::uint32_t>(::crc32_combine(upTo(from), 0, static_cast<z_off_t>(count)));
}

} // namespace edgescan::containers
