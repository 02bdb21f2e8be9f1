// Range to gray: the first stage of the method (thesis 5.4; docs/method.md, "Gray levels and presets").
#pragma once

#include "core/edges/gray/gray_loops.h"
#include "core/edges/settings/settings.h"
#include "core/scan/grid/scan.h"

namespace edgescan {

/// gray = clamp(rint(range scaled from nearMm..farMm to 0..255), 0, 255), by millimetres or by ratios.
struct GrayScale {
    double nearMm = 0.0;      ///< range of gray 0
    double farMm = 0.0;       ///< range of gray 255; equal to nearMm when the scan has no depth at all
    bool logarithmic = false; ///< equal ratios of range per level instead of equal millimetres
};

struct GrayImage {
    Grid<std::uint8_t> levels; ///< lines x beams; 0 where there is no valid return
    GrayScale scale;
    std::size_t saturated = 0; ///< valid cells whose range lies outside near..far
};

/// Works out near and far for a scan; the automatic ones come from its valid ranges.
[[nodiscard]] GrayScale grayScale(const Scan& scan, const Settings& settings);

/// What the thesis's scaling multiplies ranges with; far must be larger than near.
[[nodiscard]] LinearLevels linearLevels(const GrayScale& scale);

[[nodiscard]] GrayImage grayImage(const Scan& scan, const Settings& settings);

/// Millimetres of range that one gray level stands for at `rangeMm`; 0 when the scan has no depth at all.
[[nodiscard]] double mmPerLevel(const GrayScale& scale, double rangeMm);

} // namespace edgescan
