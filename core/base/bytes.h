// Bytes of files and sockets.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace edgescan {

using Bytes = std::vector<std::uint8_t>;
using ByteView = std::span<const std::uint8_t>;

/// The number that the bytes, eight at most, are in little-endian order.
[[nodiscard]] inline std::uint64_t littleEndian(ByteView bytes) {
    std::uint64_t value = 0;
    for (std::size_t n = std::min<std::size_t>(bytes.size(), 8); n-- > 0;) value = value << 8U | bytes[n];
    return value;
}

} // namespace edgescan
