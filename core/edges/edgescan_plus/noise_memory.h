// How the noise of neighbouring cells hangs together: white as that of a laser, or with memory as that of a depth camera, whose depth comes
// in steps that span several cells (docs/method.md, "Noise with memory").
#pragma once

#include "core/scan/grid/inverse_range.h"

#include <array>

namespace edgescan {

/// Cells between the outer and the middle cell of a second difference.
inline constexpr std::array<int, 5> kNoiseLags{1, 2, 4, 8, 16};

/// The noise by scale, measured along the beams and along the lines.
struct NoiseScales {
    double rangeM = 0; ///< median range of the cells looked at
    std::array<double, kNoiseLags.size()>
        sigmaMm{};           ///< by lag: white noise reads alike at every lag; 0 where there is too little to tell, or it was not asked
    double nilShare = 0;     ///< of the second differences, those under a twentieth of their RMS: 0.04 for normal noise
    bool inSteps = false;    ///< so many are nil that the ranges come in coarse steps
    bool remembered = false; ///< in steps that span cells: noise with memory
};
/// Lags over 2 only where the noise has memory, or all are asked for.
[[nodiscard]] NoiseScales noiseScales(const InverseRange& inverse, bool all);

/// The noise of a scan whose neighbours err alike.
struct MemoryNoise {
    RangeNoise range;    ///< of a single cell, at the lag where it stops growing
    RangeNoise fold;     ///< the white noise that would fold flat surfaces as much as is seen within the window of a fold
    double cells = 1;    ///< that err alike: the square of fold noise over what white noise of the size at lag 1 would make
    double windowMm = 0; ///< of folds
};
/// `scales` of the same sweep, `windowMm` of one side of a fold (docs/method.md, "Step 5"). Zero noise where there is too little to tell.
[[nodiscard]] MemoryNoise memoryNoise(const InverseRange& inverse, const AngularSteps& steps, const NoiseScales& scales, double windowMm);

} // namespace edgescan
