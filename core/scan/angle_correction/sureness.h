// How sure a median is (docs/method.md, "Interlaced beams and slips").
#pragma once

#include "core/base/order_statistic.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace edgescan {

/// What is told of a sweep lies this many of its own standard deviations off nothing.
inline constexpr double kSignificant = 6;

/// Standard deviation of the median of `count` values that lie `offMedian` off it, by their median size; never quite 0.
[[nodiscard]] inline double sdOfMedian(std::vector<double> offMedian, std::size_t count) {
    constexpr double kOfNormal = 1.4826;     // from the median size to the standard deviation
    constexpr double kMedianOfMean = 1.2533; // a median is that much less sure than a mean
    constexpr double kLeast = 1e-3;
    for (double& off : offMedian) off = std::abs(off);
    return std::max(kLeast, kOfNormal * kMedianOfMean * median(std::move(offMedian)) /
                                std::sqrt(static_cast<double>(std::max<std::size_t>(1, count))));
}

} // namespace edgescan
