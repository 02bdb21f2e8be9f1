// Range to gray: the first stage of the method (thesis 5.4; formulas in CLI.md).
#pragma once

#include "core/edges/settings.h"
#include "core/scan/scan.h"

namespace edgescan {

/// gray = clamp(rint(range scaled from nearMm..farMm to 0..255), 0, 255).
struct GrayScale {
    double nearMm = 0.0; ///< range of gray 0
    double farMm = 0.0;  ///< range of gray 255; equal to nearMm when the scan has no depth at all
    double mmPerLevel = 0.0;
};

struct GrayImage {
    Grid<std::uint8_t> levels;  ///< lines x beams; 0 where there is no valid return
    GrayScale scale;
    std::size_t saturated = 0;  ///< valid cells whose range lies outside near..far
};

/// Works out near and far for a scan; the automatic ones come from its valid ranges.
[[nodiscard]] GrayScale grayScale(const Scan& scan, const Settings& settings);

[[nodiscard]] GrayImage grayImage(const Scan& scan, const Settings& settings);

/// Standard deviation of the range noise, mm: median |second difference along the lines| / (0.6745 sqrt 6).
/// A smooth surface of any slope gives its noise only; 0 when there are no three valid neighbours.
[[nodiscard]] double rangeNoiseMm(const Scan& scan);

} // namespace edgescan
