// Cells of a line that a first look has marked.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace edgescan {

/// Calls visit(place) for each mark that is 1, in order; the others are 0. Fast where there are few.
template <class Visit>
void forEachMarked(const std::vector<std::uint8_t>& marks, Visit visit) {
    for (std::size_t place = 0; place < marks.size(); ++place) {
        const void* next = std::memchr(marks.data() + place, 1, marks.size() - place);
        if (next == nullptr) return;
        place = static_cast<std::size_t>(static_cast<const std::uint8_t*>(next) - marks.data());
        visit(place);
    }
}

} // namespace edgescan
