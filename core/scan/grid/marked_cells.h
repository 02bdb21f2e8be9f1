// Iterates over cells of a line that a first pass has marked for a closer check.
#pragma once

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

} // namespace edgescan
