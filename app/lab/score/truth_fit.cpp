// Checks whether a ground truth belongs to a scan.
#include "app/lab/score/truth_fit.h"

#include "core/scan/grid/inverse_range.h"

#include <algorithm>
#include <cmath>

namespace edgescan::lab {
namespace {

constexpr double kLargestRange = 65535.0; // mm; range_clean.png has 16 bits
constexpr double kSigmas = 5.0;
constexpr double kShareOfRange = 0.01; // a beam has a width, and a slanted surface has many ranges within it
constexpr double kOffsetMm = 20.0;
constexpr double kUnknownShare = 0.05; // if there are too few cells to measure the noise
constexpr double kFewest = 0.85;       // the scan itself gives more than 0.9, another bell with the same wall 0.75

// Share of the ranges (without isolated cells) that agree with the clean ranges: within five standard deviations of the scan's own noise +
// 1 % + 20 mm. Near 1 for the scan itself with any noise, drop-outs, dust or slips; 1 if the truth has no clean ranges.
double shareOfTrueRanges(const Scan& scan, const sim::TruthSet& truth) {
    if (truth.cleanMm.size() == 0) return 1.0;
    const InverseRange inverse = inverseRange(scan);
    const RangeNoise noise = rangeNoise(inverse);
    const bool known = noise.offsetMm > 0 || noise.perMetreMm > 0;
    std::size_t measured = 0;
    std::size_t fitting = 0;
    for (std::size_t k = 0; k < scan.cells(); ++k) {
        if (inverse.support[k] != Support::Measured) continue;
        ++measured;
        if (truth.cleanMm[k] == 0) continue;
        const double cleanMm = truth.cleanMm[k];
        const double allowed =
            kOffsetMm + (known ? kShareOfRange * cleanMm + kSigmas * noise.at(0.001 * cleanMm) : kUnknownShare * cleanMm);
        const double rangeMm = std::min(static_cast<double>(scan.rangeMm[k]), kLargestRange);
        fitting += std::abs(rangeMm - cleanMm) <= allowed ? 1 : 0;
    }
    return measured == 0 ? 1.0 : static_cast<double>(fitting) / static_cast<double>(measured);
}

} // namespace

Result<Done> checkTruthFits(const Scan& scan, const sim::TruthSet& truth, const std::string& folder) {
    const double share = shareOfTrueRanges(scan, truth);
    if (share >= kFewest) return Done{};
    return Error{"the truth is of another scene: " + std::to_string(std::lround(100 * share)) + " % of the ranges of " + scan.path +
                     " are those of range_clean.png",
                 folder, "give the folder that was written with the scan"};
}

} // namespace edgescan::lab
