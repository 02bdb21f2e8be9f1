// Cells of a line that a first look over all of them has marked for a closer one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace edgescan {

/// Calls visit(place) for each value that is 1, in order; the others must be 0. Fast where only few are 1.
template <class Visit>
void forEachMarked(const std::vector<std::uint8_t>& marked, Visit visit) {
    for (std::size_t place = 0; place < marked.size(); ++place) {
        const void* next = std::memchr(marked.data() + place, 1, marked.size() - place);
        if (next == nullptr) return;
        place = static_cast<std::size_t>(static_cast<const std::uint8_t*>(next) - marked.data());
        visit(place);
    }
}

} // namespace edgescan
