// Second differences along the lines, in bins of the range.
#include "core/rocks/segmentation/least_noise.h"

#include "core/base/order_statistic.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace edgescan::rocks {
namespace {

constexpr float kBinsPerM = 2;
constexpr std::size_t kBins = 120;
constexpr std::size_t kFewest = 500;   // cells of a bin
constexpr double kFewestShare = 0.01;  // of all cells
constexpr std::size_t kCells = 250000; // are enough for the estimate
constexpr double kQuantile = 0.40;
constexpr double kQuantileOfNormal = 0.524; // the quantile of |N(0, 1)| at 40 %
// Noise of an LMS511 at a range, as a share of that at 5 m.
constexpr double kShareAt0M = 0.815, kSharePerM = 0.037;

} // namespace

double leastNoiseMm(const InverseRange& inverse) {
    std::vector<std::vector<float>> bins(kBins);
    std::size_t all = 0;
    const int every = std::max(1, static_cast<int>(inverse.u.size() / kCells));
    for (int i = std::min(every, inverse.u.lines) / 2; i < inverse.u.lines; i += every) {
        const float* u = inverse.u.line(i);
        const Support* support = inverse.support.line(i);
        for (int j = 1; j + 1 < inverse.u.beams; ++j) {
            if (support[j - 1] != Support::Measured || support[j] != Support::Measured || support[j + 1] != Support::Measured) continue;
            const float range = 1.0F / u[j];
            if (!(range * kBinsPerM < static_cast<float>(kBins))) continue;
            bins[static_cast<std::size_t>(range * kBinsPerM)].push_back(std::abs(u[j - 1] - 2 * u[j] + u[j + 1]) * range * range);
            ++all;
        }
    }
    double least = 0;
    for (std::size_t n = 0; n < kBins; ++n) {
        const std::vector<float>& off = bins[n];
        if (off.size() < kFewest || static_cast<double>(off.size()) < kFewestShare * static_cast<double>(all)) continue;
        const float quantile = nthSmallest(off, static_cast<std::size_t>(kQuantile * static_cast<double>(off.size())));
        const double sigmaMm = 1000.0 * static_cast<double>(quantile) / std::sqrt(6.0) / kQuantileOfNormal;
        const double at5M = sigmaMm / (kShareAt0M + kSharePerM * (static_cast<double>(n) + 0.5) / static_cast<double>(kBinsPerM));
        if (least == 0 || at5M < least) least = at5M;
    }
    return least;
}

} // namespace edgescan::rocks
