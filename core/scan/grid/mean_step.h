// The mean step between angles of lines or beams.
#pragma once

#include <vector>

namespace edgescan {

/// Degrees from one angle to the next, negative where they decrease; needs two angles.
[[nodiscard]] inline double meanStepDeg(const std::vector<double>& deg) {
    return (deg.back() - deg.front()) / static_cast<double>(deg.size() - 1);
}

} // namespace edgescan
