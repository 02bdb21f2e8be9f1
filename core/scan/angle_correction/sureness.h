// The uncertainty of a median (docs/method/edges.md, "Interlaced beams and slips").
#pragma once

#include "core/base/order_statistic.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace edgescan {

/// A displacement is reported if it is at least this many of its standard deviations away from 0.
inline constexpr double kSignificantSds = 6;

/// Standard deviation of the median of `count` values, estimated from the median size of `offMedian`, their deviations from the median;
/// always more than 0.
[[nodiscard]] inline double sdOfMedian(std::vector<double> offMedian, std::size_t count) {
    constexpr double kOfNormal = 1.4826;     // converts the median size to the standard deviation
    constexpr double kMedianOfMean = 1.2533; // the standard deviation of a median is this many times that of a mean
    constexpr double kLeast = 1e-3;
    for (double& off : offMedian) off = std::abs(off);
    return std::max(kLeast, kOfNormal * kMedianOfMean * median(std::move(offMedian)) /
                                std::sqrt(static_cast<double>(std::max<std::size_t>(1, count))));
}

} // namespace edgescan
