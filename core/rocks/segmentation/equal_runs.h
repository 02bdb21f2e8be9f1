// Runs of consecutive equal numbers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace edgescan::rocks {

/// Calls say(number, first index, index behind the last) for each run of equal numbers, in order.
template <class Say>
void eachEqualRun(std::span<const std::uint32_t> numbers, const Say& say) {
    for (std::size_t begin = 0; begin < numbers.size();) {
        std::size_t end = begin + 1;
        while (end < numbers.size() && numbers[end] == numbers[begin]) ++end;
        say(numbers[begin], begin, end);
        begin = end;
    }
}

} // namespace edgescan::rocks
