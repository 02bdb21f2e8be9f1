// Converts ranges to gray levels: the first stage of the method (thesis 5.4; docs/method/edges.md, "Gray levels and presets").
#pragma once

#include "core/edges/gray/gray_loops.h"
#include "core/edges/settings/settings.h"
#include "core/scan/grid/scan.h"

namespace edgescan::edges {

/// gray = clamp(rint(range scaled from nearMm..farMm to 0..255), 0, 255), linear in millimetres or logarithmic.
struct GrayScale {
    double nearMm = 0.0;      ///< range of gray 0, mm
    double farMm = 0.0;       ///< range of gray 255, mm; equal to nearMm if the scan has no depth
    bool logarithmic = false; ///< equal ratios of range per level instead of equal millimetres
};

struct GrayImage {
    Grid<std::uint8_t> levels; ///< lines x beams; 0 where there is no valid return
    GrayScale scale;
    std::size_t saturated = 0; ///< number of valid cells whose range is outside near..far
};

/// Computes near and far for a scan; automatic values come from its valid ranges.
[[nodiscard]] GrayScale grayScale(const Scan& scan, const Settings& settings);

/// The factor by which the thesis's scaling multiplies ranges; far must be larger than near.
[[nodiscard]] LinearLevels linearLevels(const GrayScale& scale);

/// The gray image of a scan with the scaling of the settings: levels are lines x beams, 0 where there is no valid return.
[[nodiscard]] GrayImage grayImage(const Scan& scan, const Settings& settings);

/// Range in mm per gray level at `rangeMm`; 0 if the scan has no depth.
[[nodiscard]] double mmPerLevel(const GrayScale& scale, double rangeMm);

} // namespace edgescan::edges
