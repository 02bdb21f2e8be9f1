// Little-endian bytes and their checksum.
#include "core/mcap/mcap_records.h"

#include <zlib.h>

#include <cstring>

namespace edgescan {

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

} // namespace edgescan
