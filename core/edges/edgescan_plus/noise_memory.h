// Correlation between the noise of neighbouring cells: white noise as that of a laser, or noise with memory as that of a depth camera,
// whose depth has steps that span several cells (docs/method/edges.md, "Noise with memory").
#pragma once

#include "core/scan/grid/inverse_range.h"

#include <array>

namespace edgescan::edges {

/// Number of cells between the outer and the middle cell of a second difference.
inline constexpr std::array<int, 5> kNoiseLags{1, 2, 4, 8, 16};

/// The noise at several scales, measured along the beams and along the lines.
struct NoiseScales {
    double rangeM = 0; ///< median range of the sampled cells, m
    /// by lag, mm: white noise gives the same value at every lag; 0 if there are too few cells, or if the lag was not requested
    std::array<double, kNoiseLags.size()> sigmaMm{};
    double nilShare = 0;     ///< share of the second differences smaller than a twentieth of their RMS: 0.04 for normal noise
    bool inSteps = false;    ///< so many differences are nil that the ranges come in coarse steps
    bool remembered = false; ///< the steps span several cells: noise with memory
};
/// Lags above 2 are measured only if the noise has memory, or if `all` is set.
[[nodiscard]] NoiseScales noiseScales(const InverseRange& inverse, bool all);

/// The noise of a scan in which the errors of neighbours are correlated.
struct MemoryNoise {
    RangeNoise range;    ///< noise of a single cell, at the lag where it stops growing
    RangeNoise fold;     ///< the white noise that would cause as large folds on flat surfaces as are seen within the window of a fold
    double cells = 1;    ///< number of correlated cells: the square of (fold noise / fold noise of white noise with the size at lag 1)
    double windowMm = 0; ///< window of folds, mm
};
/// `scales` of the same sweep, `windowMm` of one side of a fold (docs/method/edges.md, "Step 5"). Zero noise if there are too few cells.
[[nodiscard]] MemoryNoise memoryNoise(const InverseRange& inverse, const AngularSteps& steps, const NoiseScales& scales, double windowMm);

} // namespace edgescan::edges
