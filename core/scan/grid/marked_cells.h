// Iterates over the few cells of a line or a grid that are marked.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace edgescan {

/// Calls visit(place) for each value that is 1, in order. Fast if few are marked.
template <class Visit>
void forEachMarked(std::span<const std::uint8_t> marked, Visit visit) {
    for (std::size_t place = 0; place < marked.size(); ++place) {
        const void* next = std::memchr(marked.data() + place, 1, marked.size() - place);
        if (next == nullptr) return;
        place = static_cast<std::size_t>(static_cast<const std::uint8_t*>(next) - marked.data());
        visit(place);
    }
}

/// The same for each value of a mask that is not 0, eight at a time.
template <class Visit>
void forEachNotZero(std::span<const std::uint8_t> mask, Visit visit) {
    static_assert(std::endian::native == std::endian::little);
    constexpr std::size_t kAtOnce = 8;
    std::size_t place = 0;
    for (; place + kAtOnce <= mask.size(); place += kAtOnce) {
        std::uint64_t eight = 0;
        std::memcpy(&eight, mask.data() + place, kAtOnce);
        // A bit in the highest place of each byte that is not 0, the first in the lowest byte.
        std::uint64_t left = (((eight & 0x7F7F7F7F7F7F7F7FU) + 0x7F7F7F7F7F7F7F7FU) | eight) & 0x8080808080808080U;
        for (; left != 0; left &= left - 1) visit(place + static_cast<std::size_t>(std::countr_zero(left)) / 8);
    }
    for (; place < mask.size(); ++place) {
        if (mask[place] != 0) visit(place);
    }
}

} // namespace edgescan
