// The thesis's recipe as a student would write it: pixel by pixel, and clouds that grow by push_back.
#pragma once

#include "core/scan/grid/scan.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace edgescan::bench {

struct NaivePoint {
    double x, y, z;
    std::size_t index;
    int label; ///< 1 = edge
};

/// Gray levels, 3 x 3 Gaussian, Sobel, suppression along four directions, hysteresis 1:3, and a point per valid cell.
[[nodiscard]] std::vector<NaivePoint> naiveThesis(const Scan& scan, int lower);

} // namespace edgescan::bench
