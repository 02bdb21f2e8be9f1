// The sweep in inverse range u = 1 / r, in which a plane is a straight line along every scan line (docs/method/edges.md, "EdgeScan+").
#pragma once

#include "core/scan/grid/scan.h"

#include <cstdint>
#include <vector>

namespace edgescan {

/// The meaning of a cell's inverse range.
enum class Support : std::uint8_t {
    Void,          ///< no return: u is that of 60 m
    Measured,      ///< a measured range that agrees with its neighbours
    Filled,        ///< a short gap, filled linearly in u; never an edge
    RequestedFill, ///< a gap that the operator wants filled and processed (core/scan/gap_filling); may be an edge
};

struct InverseRange {
    Grid<float> u;         ///< lines x beams, 1/m
    Grid<Support> support; ///< lines x beams

    [[nodiscard]] bool isMeasured(int line, int beam) const { return support.at(line, beam) == Support::Measured; }
};

/// The angle of one index step, radians.
struct AngularSteps {
    std::vector<float> beam;     ///< `beams` values: along the fan
    std::vector<float> line;     ///< `lines` values: across the lines, at right angles to the rotation axis ...
    std::vector<float> fromAxis; ///< ... times `beams` values: the sine of the angle from the rotation axis

    [[nodiscard]] float lineAt(int i, int j) const { return line[static_cast<std::size_t>(i)] * fromAxis[static_cast<std::size_t>(j)]; }
};

/// The first step (docs/method/edges.md, "Step 1"): drops isolated cells, and fills gaps of up to 4 cells with measured cells on both
/// sides. The result is the same for any number of threads (0: as many as make it faster).
[[nodiscard]] InverseRange inverseRange(const Scan& scan, int threads = 1);

/// For an organised cloud the steps are the angles between neighbouring points as seen from the sensor; where they are missing, their
/// median.
[[nodiscard]] AngularSteps angularSteps(const Scan& scan);

/// Range noise: standard deviation sigma(r) = offsetMm + perMetreMm * r[m] + perSquareMetreMm * r^2, in mm.
struct RangeNoise {
    double offsetMm = 0.0;
    double perMetreMm = 0.0;
    double perSquareMetreMm = 0.0; ///< for depths computed from a disparity
    [[nodiscard]] double at(double rangeM) const { return offsetMm + perMetreMm * rangeM + perSquareMetreMm * rangeM * rangeM; }
};
/// The noise of an LMS511.
inline constexpr RangeNoise kScannerNoise{0.815 * 6.75, 0.037 * 6.75, 0};

/// The noise of a sweep, from |second differences of u| along the lines in tiles of 8 x 8 cells. Relief, slant and wide cells only add to
/// them, and more to those of every second cell. So the flattest tiles of both show the noise (docs/method/edges.md, "Step 6"). With fewer
/// than 75 tiles `ofRange` takes a growing share, and with 25 it is the result.
struct TileNoise {
    RangeNoise measured; ///< a multiple of kScannerNoise: for tolerances
    RangeNoise steady;   ///< for thresholds: a multiple near 1 is 1, so that a part of a scan has those of the whole
};
[[nodiscard]] TileNoise tileNoise(const InverseRange& inverse, const RangeNoise& ofRange);
/// The measured noise of the tiles.
[[nodiscard]] RangeNoise rangeNoise(const InverseRange& inverse);

/// A line through the noise in bins of range: the 40 % quantile of |second differences of u| along the lines. Relief and slant count as
/// noise. Zero if there are too few cells.
[[nodiscard]] RangeNoise noiseByRange(const InverseRange& inverse);

/// The distance between neighbouring points, mm: the side of the square that a cell covers across the beam, median of the measured cells.
/// Zero if no cell was measured.
[[nodiscard]] double pointSpacingMm(const InverseRange& inverse, const AngularSteps& steps);

} // namespace edgescan
