// The n-th smallest of several numbers; the median.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace edgescan {

/// The value at place `n` of the sorted values; n < their count. Reorders the values.
template <class T>
[[nodiscard]] T valueInOrder(std::vector<T>& values, std::size_t n) {
    const auto place = values.begin() + static_cast<std::ptrdiff_t>(n);
    std::nth_element(values.begin(), place, values.end());
    return *place;
}

/// The value that a share (0 to 1) of the values is below. Needs at least one value; reorders the values.
template <class T>
[[nodiscard]] T quantile(std::vector<T>& values, double share) {
    return valueInOrder(values, static_cast<std::size_t>(share * static_cast<double>(values.size() - 1)));
}

/// The middle value; of an even number the upper of the two; `none` if there are no values.
template <class T>
[[nodiscard]] T median(std::vector<T> values, T none = {}) {
    return values.empty() ? none : valueInOrder(values, values.size() / 2);
}

/// The result of valueInOrder() for many floats, in two passes over them. The values must be 0 or more, without NaN.
[[nodiscard]] inline float nthSmallest(std::span<const float> values, std::size_t n) {
    // The bits of non-negative floats are in the order of the numbers. The upper bits give the interval of the result, which holds a few
    // per cent of the values.
    constexpr unsigned kLower = 17;
    const auto neighbourhood = [](float value) { return (std::bit_cast<std::uint32_t>(value) & 0x7FFFFFFFU) >> kLower; };
    std::vector<std::uint32_t> counts(std::size_t{1} << (31 - kLower)); // without the sign bit
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
