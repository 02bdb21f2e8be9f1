// Finds the few cells of a mask.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace edgescan::files {

/// Calls found(n) for each of `count` bytes that is not 0, eight at a time.
template <class Found>
void forEachMarked(const std::uint8_t* mask, std::size_t count, Found found) {
    static_assert(std::endian::native == std::endian::little);
    constexpr std::size_t kAtOnce = 8;
    std::size_t n = 0;
    for (; n + kAtOnce <= count; n += kAtOnce) {
        std::uint64_t eight = 0;
        std::memcpy(&eight, mask + n, kAtOnce);
        // A bit in the highest place of each byte that is not 0, the first in the lowest byte.
        std::uint64_t left = (((eight & 0x7F7F7F7F7F7F7F7FU) + 0x7F7F7F7F7F7F7F7FU) | eight) & 0x8080808080808080U;
        for (; left != 0; left &= left - 1) found(n + static_cast<std::size_t>(std::countr_zero(left)) / 8);
    }
    for (; n < count; ++n) {
        if (mask[n] != 0) found(n);
    }
}

} // namespace edgescan::files
