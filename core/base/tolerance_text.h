// The uncertainty of a measured value as text.
#pragma once

#include <algorithm>
#include <cmath>

namespace edgescan {

/// The tolerance to be written with `decimals` decimals: never below one unit of the last one. "± 0.000" would promise what nothing
/// measures. Zero, which means that it is not known, stays zero.
[[nodiscard]] inline double shownTolerance(double tolerance, int decimals) {
    return tolerance > 0.0 ? std::max(tolerance, std::pow(10.0, -decimals)) : tolerance;
}

} // namespace edgescan
