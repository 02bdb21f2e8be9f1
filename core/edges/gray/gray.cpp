// Converts ranges to gray levels.
#include "core/edges/gray/gray.h"

#include "core/base/order_statistic.h"
#include "core/base/portable_math.h"
#include "core/base/simd.h"
#include "core/edges/gray/gray_loops.h"
#include "core/edges/settings/method_traits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace edgescan::edges {
namespace {

constexpr double kLevels = 255.0;
constexpr double kTrimmedShare = 0.01;      // share of the ranges that is cut off at either end
constexpr double kSmallestRatio = 5.0;      // far / near: a wall seen at 75 degrees then stays below the default thresholds ...
constexpr double kSmallestOfPicture = 1.2;  // ... and where no threshold reads the levels, a wall is not gray all over
constexpr double kFractionsOfMm = 1024.0;   // limits of levels are rounded to this fraction, so that every libm gives the same mask
constexpr std::size_t kTableMm = 1U << 17U; // ranges up to this are looked up in a table instead of searched

// The number of valid cells of each whole millimetre; empty if a range has a fraction of a millimetre or is kTableMm and more.
using Counts = std::vector<std::uint32_t>;
Counts countsOf(const Scan& scan) {
    std::array<Counts, 2> counts; // neighbours often have the same range: their additions do not wait for each other
    counts.fill(Counts(kTableMm));
    for (std::size_t k = 0; k < scan.cells(); ++k) {
        if (scan.state[k] != CellState::Valid) continue;
        const float range = scan.rangeMm[k];
        if (!(range >= 0 && range < static_cast<float>(kTableMm))) return {};
        const auto mm = static_cast<std::uint32_t>(range);
        if (static_cast<float>(mm) != range) return {};
        ++counts[k % 2][mm];
    }
    for (std::size_t mm = 0; mm < kTableMm; ++mm) counts[0][mm] += counts[1][mm];
    return std::move(counts[0]);
}

// The ranges that kTrimmedShare of all valid ranges above 0 are below and above of, mm; 0 if there are none.
std::array<double, 2> trimmedRanges(const Scan& scan, const Counts& counts) {
    const auto trimmed = [](std::size_t all) { return static_cast<std::size_t>(kTrimmedShare * static_cast<double>(all - 1)); };
    if (!counts.empty()) {
        const std::size_t all = std::accumulate(counts.begin() + 1, counts.end(), std::size_t{0});
        const auto nth = [&](std::size_t n) {
            std::size_t mm = 1, upTo = counts[1];
            while (upTo <= n) upTo += counts[++mm];
            return static_cast<double>(mm);
        };
        if (all == 0) return {};
        return {nth(trimmed(all)), nth(all - 1 - trimmed(all))};
    }
    std::vector<float> ranges;
    ranges.reserve(scan.cells());
    for (std::size_t k = 0; k < scan.cells(); ++k) {
        if (scan.state[k] == CellState::Valid && scan.rangeMm[k] > 0) ranges.push_back(scan.rangeMm[k]);
    }
    if (ranges.empty()) return {};
    return {nthSmallest(ranges, trimmed(ranges.size())), nthSmallest(ranges, ranges.size() - 1 - trimmed(ranges.size()))};
}

// 1 % and 99 % of the valid ranges, at least a factor `smallestRatio` apart.
GrayScale logScale(const Scan& scan, const Counts& counts, double smallestRatio) {
    auto [nearMm, farMm] = trimmedRanges(scan, counts);
    if (nearMm == 0) return {};
    if (farMm < nearMm * smallestRatio) {
        const double middle = std::sqrt(nearMm * farMm);
        nearMm = middle / std::sqrt(smallestRatio);
        farMm = nearMm * smallestRatio;
    }
    // Whole millimetres, so that the displayed numbers are the numbers in use.
    return {std::max(1.0, std::round(nearMm)), std::round(farMm), true};
}

// limits[n] is the range at which level n changes to level n + 1.
std::array<double, 255> logLimits(const GrayScale& scale) {
    std::array<double, 255> limits{};
    const double ratio = portable::log(scale.farMm / scale.nearMm);
    for (std::size_t n = 0; n < limits.size(); ++n) {
        const double range = scale.nearMm * portable::exp(ratio * (static_cast<double>(n) + 0.5) / kLevels);
        limits[n] = std::round(range * kFractionsOfMm) / kFractionsOfMm;
    }
    return limits;
}

// Converts a line of ranges to levels by plain arithmetic; returns how many are outside near..far.
template <class LevelOf>
EDGESCAN_INLINE int computeLevels(const float* rangeMm, const CellState* states, int beams, const GrayScale& scale, LevelOf levelOf,
                                  std::uint8_t* __restrict levels) {
    int outside = 0;
    for (int j = 0; j < beams; ++j) {
        const double range = rangeMm[j];
        const bool valid = states[j] == CellState::Valid;
        const double level = std::clamp(std::nearbyint(levelOf(range)), 0.0, kLevels);
        levels[j] = static_cast<std::uint8_t>(static_cast<int>(valid ? level : 0.0));
        outside += valid & ((range < scale.nearMm) | (range > scale.farMm)) ? 1 : 0;
    }
    return outside;
}

EDGESCAN_INLINE int computeWindowLevels(const float* rangeMm, const CellState* states, int beams, const GrayScale& scale,
                                        std::uint8_t* __restrict levels) {
    const double nearMm = scale.nearMm;
    const double span = scale.farMm - scale.nearMm;
    return computeLevels(
        rangeMm, states, beams, scale, [nearMm, span](double range) { return (range - nearMm) * kLevels / span; }, levels);
}

template <class LevelOf>
void fillLevels(GrayImage& gray, const Scan& scan, LevelOf levelOf) {
    for (std::size_t k = 0; k < scan.cells(); ++k) {
        if (scan.state[k] != CellState::Valid) continue;
        const double range = scan.rangeMm[k];
        gray.levels[k] = levelOf(range);
        gray.saturated += range < gray.scale.nearMm || range > gray.scale.farMm ? 1U : 0U;
    }
}

// Whole millimetres are looked up, other ranges are searched among the limits.
void fillLogLevels(GrayImage& gray, const Scan& scan, const Counts& counts) {
    const std::array<double, 255> limits = logLimits(gray.scale);
    const auto search = [&](double range) {
        return static_cast<std::uint8_t>(std::upper_bound(limits.begin(), limits.end(), range) - limits.begin());
    };
    std::vector<std::uint8_t> table(kTableMm);
    std::size_t mm = 0;
    for (std::size_t level = 0; level < limits.size(); ++level) {
        for (; mm < kTableMm && static_cast<double>(mm) < limits[level]; ++mm) table[mm] = static_cast<std::uint8_t>(level);
    }
    std::fill(table.begin() + static_cast<std::ptrdiff_t>(mm), table.end(), std::uint8_t{255});
    if (counts.empty()) {
        fillLevels(gray, scan, [&](double range) {
            if (!(range >= 0 && range < static_cast<double>(kTableMm))) return search(range);
            const auto whole = static_cast<std::uint32_t>(range);
            return static_cast<double>(whole) == range ? table[whole] : search(range);
        });
        return;
    }
    for (std::size_t k = 0; k < scan.cells(); ++k) {
        if (scan.state[k] == CellState::Valid) gray.levels[k] = table[static_cast<std::uint32_t>(scan.rangeMm[k])];
    }
    for (std::size_t range = 0; range < kTableMm; ++range) {
        const auto here = static_cast<double>(range);
        if (here < gray.scale.nearMm || here > gray.scale.farMm) gray.saturated += counts[range];
    }
}

GrayScale scaleOf(const Scan& scan, const Settings& settings, const Counts& counts) {
    const bool logarithmic = settings.scaling == Scaling::Log;
    GrayScale scale;
    if (logarithmic) {
        scale = logScale(scan, counts, reads(settings.method, kReadsGray) ? kSmallestRatio : kSmallestOfPicture);
    } else {
        const RangeLimits limits = rangeLimits(scan);
        scale = {limits.minMm, limits.maxMm, false};
    }
    // As printed in the thesis, c = 255 / (Smax - Smin) multiplies S itself: gray 0 is at range 0.
    if (settings.scaling == Scaling::Thesis) return {0.0, scale.farMm - scale.nearMm, false};
    if (!std::isnan(settings.nearMm)) scale.nearMm = settings.nearMm;
    if (!std::isnan(settings.farMm)) scale.farMm = settings.farMm;
    if (logarithmic) scale.nearMm = std::max(1.0, scale.nearMm);
    scale.farMm = std::max(scale.nearMm, scale.farMm);
    return scale;
}

} // namespace

GrayScale grayScale(const Scan& scan, const Settings& settings) { return scaleOf(scan, settings, {}); }

LinearLevels linearLevels(const GrayScale& scale) { return {kLevels / (scale.farMm - scale.nearMm), scale.nearMm, scale.farMm}; }

GrayImage grayImage(const Scan& scan, const Settings& settings) {
    const Counts counts = settings.scaling == Scaling::Log ? countsOf(scan) : Counts{};
    GrayImage gray{Grid<std::uint8_t>(scan.lines(), scan.beams()), scaleOf(scan, settings, counts), 0};
    if (gray.scale.farMm <= gray.scale.nearMm) { // all ranges are equal, or a typed limit is beyond the other: no depth, all levels 0
        fillLevels(gray, scan, [](double) { return std::uint8_t{0}; });
        return gray;
    }
    if (settings.scaling == Scaling::Log) {
        fillLogLevels(gray, scan, counts);
        return gray;
    }
    if (settings.scaling == Scaling::Thesis) {
        gray.saturated = levelsBy(instructionSet(), scan.rangeMm, scan.state, linearLevels(gray.scale), gray.levels);
        return gray;
    }
    for (int i = 0; i < scan.lines(); ++i)
        gray.saturated += static_cast<std::size_t>(
            vectorised<computeWindowLevels>(scan.rangeMm.line(i), scan.state.line(i), scan.beams(), gray.scale, gray.levels.line(i)));
    return gray;
}

double mmPerLevel(const GrayScale& scale, double rangeMm) {
    if (scale.farMm <= scale.nearMm) return 0.0;
    if (scale.logarithmic) return rangeMm * std::log(scale.farMm / scale.nearMm) / kLevels;
    return (scale.farMm - scale.nearMm) / kLevels;
}

} // namespace edgescan::edges
