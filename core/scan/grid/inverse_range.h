// The sweep in inverse range u = 1 / r, in which a plane is a straight line along every scan line (docs/method.md, "EdgeScan+").
#pragma once

#include "core/scan/grid/scan.h"

#include <cstdint>
#include <vector>

namespace edgescan {

/// What a cell's inverse range stands for.
enum class Support : std::uint8_t {
    Void,     ///< nothing came back: u is that of 60 m
    Measured, ///< a range that its neighbours agree with
    Filled,   ///< a short gap, filled linearly in u; never an edge
    Wanted,   ///< a gap that somebody wants filled and taken part in (core/scan/gap_filling); may be an edge
};

struct InverseRange {
    Grid<float> u;         ///< lines x beams, 1/m
    Grid<Support> support; ///< lines x beams

    [[nodiscard]] bool isMeasured(int line, int beam) const { return support.at(line, beam) == Support::Measured; }
};

/// Angular size of one index step, radians.
struct AngularSteps {
    std::vector<float> beam;     ///< beams values: along the fan
    std::vector<float> line;     ///< lines values: across the lines, at right angles to the rotation axis ...
    std::vector<float> fromAxis; ///< ... times beams values, the sine of the angle from it

    [[nodiscard]] float lineAt(int i, int j) const { return line[static_cast<std::size_t>(i)] * fromAxis[static_cast<std::size_t>(j)]; }
};

/// The first step (docs/method.md, "Step 1"): cells that stand alone are dropped, gaps of up to 4 cells with both sides present are filled.
/// The same with any number of threads (0: as many as pay).
[[nodiscard]] InverseRange inverseRange(const Scan& scan, int threads = 1);

/// For an organised cloud the steps are the angles between neighbouring points as seen from the sensor, their median where missing.
[[nodiscard]] AngularSteps angularSteps(const Scan& scan);

/// Range noise sigma(r) = offsetMm + perMetreMm * r[m] + perSquareMetreMm * r^2; rangeNoise() has no square, from the 40 % quantile of
/// |second differences of u| along the lines in range bins (docs/method.md, "Step 6"). Zero where there is too little to tell.
struct RangeNoise {
    double offsetMm = 0.0;
    double perMetreMm = 0.0;
    double perSquareMetreMm = 0.0; ///< depth from a disparity
    [[nodiscard]] double at(double rangeM) const { return offsetMm + perMetreMm * rangeM + perSquareMetreMm * rangeM * rangeM; }
};
[[nodiscard]] RangeNoise rangeNoise(const InverseRange& inverse);

/// How far apart neighbouring points lie, mm: the side of the square that a cell covers across the beam, median of the measured cells.
/// Zero where nothing was measured.
[[nodiscard]] double pointSpacingMm(const InverseRange& inverse, const AngularSteps& steps);

} // namespace edgescan
