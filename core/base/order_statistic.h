// The n-th smallest of numbers; the median.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace edgescan {

/// What stands at place `n` once the values are in order; n < their count. Moves the values.
template <class T>
[[nodiscard]] T valueInOrder(std::vector<T>& values, std::size_t n) {
    const auto place = values.begin() + static_cast<std::ptrdiff_t>(n);
    std::nth_element(values.begin(), place, values.end());
    return *place;
}

/// The value that a share of them, 0 to 1, lies below. There is at least one; moves the values.
template <class T>
[[nodiscard]] T quantile(std::vector<T>& values, double share) {
    return valueInOrder(values, static_cast<std::size_t>(share * static_cast<double>(values.size() - 1)));
}

/// The middle value; of an even number the upper of the two; `none` where there is no value.
template <class T>
[[nodiscard]] T median(std::vector<T> values, T none = {}) {
    return values.empty() ? none : valueInOrder(values, values.size() / 2);
}

/// What valueInOrder() would give for many floats, in two passes over them. Values from 0 up, no NaN.
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
    return valueInOrder(near, n);
}

} // namespace edgescan
