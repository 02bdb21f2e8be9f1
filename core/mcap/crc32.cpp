// CRC-32, by zlib.
#include "core/mcap/crc32.h"

#include <zlib.h>

namespace edgescan {

std::uint32_t crc32(std::span<const std::uint8_t> bytes, std::uint32_t before) {
    return static_cast<std::uint32_t>(::crc32_z(before, bytes.data(), bytes.size()));
}

} // namespace edgescan
