// The n-th smallest of many numbers in two passes over them.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace edgescan {

/// What std::nth_element would put at place `n`: the same number, faster for many. Values from 0 up, no NaN; n < their count.
[[nodiscard]] inline float nthSmallest(std::span<const float> values, std::size_t n) {
    // Bits of numbers from 0 up are in the order of the numbers: the upper ones tell the neighbourhood, a few per cent of the values.
    constexpr unsigned kLower = 17;
    const auto neighbourhood = [](float value) { return (std::bit_cast<std::uint32_t>(value) & 0x7FFFFFFFU) >> kLower; };
    std::vector<std::uint32_t> counts(std::size_t{1} << (31 - kLower)); // no sign
    for (const float value : values) ++counts[neighbourhood(value)];
    std::uint32_t wanted = 0;
    while (n >= counts[wanted]) n -= counts[wanted++];
    std::vector<float> near;
    near.reserve(counts[wanted]);
    for (const float value : values) {
        if (neighbourhood(value) == wanted) near.push_back(value);
    }
    const auto place = near.begin() + static_cast<std::ptrdiff_t>(n);
    std::nth_element(near.begin(), place, near.end());
    return *place;
}

} // namespace edgescan
