// Cells of a line that a first look over all of them has marked for a closer one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace edgescan {

/// Calls visit(place) for each value that is 1, in order. Fast where only few are.
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
