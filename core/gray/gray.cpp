// Range to gray.
#include "core/gray/gray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace edgescan {
namespace {

constexpr double kLevels = 255.0;
constexpr double kTrimmedShare = 0.01;      // of the ranges at either end
constexpr double kSmallestRatio = 5.0;      // far / near: a wall seen at 75 degrees then stays below the default thresholds
constexpr double kFractionsOfMm = 1024.0;   // limits of levels are rounded to these, so that every libm gives the same mask
constexpr std::size_t kTableMm = 1U << 17U; // ranges looked up instead of searched

// 1 % and 99 % of the valid ranges, kSmallestRatio apart at least.
GrayScale logScale(const Scan& scan) {
    std::vector<float> ranges;
    ranges.reserve(scan.cells());
    for (std::size_t k = 0; k < scan.cells(); ++k) {
        if (scan.state[k] == CellState::Valid && scan.rangeMm[k] > 0) ranges.push_back(scan.rangeMm[k]);
    }
    if (ranges.empty()) return {};
    const auto trimmed = static_cast<std::ptrdiff_t>(kTrimmedShare * static_cast<double>(ranges.size() - 1));
    const auto low = ranges.begin() + trimmed;
    const auto high = ranges.end() - 1 - trimmed;
    std::nth_element(ranges.begin(), low, ranges.end());
    double nearMm = *low;
    std::nth_element(low, high, ranges.end()); // moves what stood at `low`
    double farMm = *high;
    if (farMm < nearMm * kSmallestRatio) {
        const double middle = std::sqrt(nearMm * farMm);
        nearMm = middle / std::sqrt(kSmallestRatio);
        farMm = nearMm * kSmallestRatio;
    }
    // Whole millimetres: the numbers shown are the numbers used.
    return {std::max(1.0, std::round(nearMm)), std::round(farMm), true};
}

// limits[n] is the range at which level n turns into level n + 1.
std::array<double, 255> logLimits(const GrayScale& scale) {
    std::array<double, 255> limits{};
    const double ratio = std::log(scale.farMm / scale.nearMm);
    for (std::size_t n = 0; n < limits.size(); ++n) {
        const double range = scale.nearMm * std::exp(ratio * (static_cast<double>(n) + 0.5) / kLevels);
        limits[n] = std::round(range * kFractionsOfMm) / kFractionsOfMm;
    }
    return limits;
}

std::uint8_t clampedLevel(double level) { return static_cast<std::uint8_t>(std::clamp(std::nearbyint(level), 0.0, kLevels)); }

template <class LevelOf>
void fillLevels(GrayImage& gray, const Scan& scan, LevelOf levelOf) {
    for (std::size_t k = 0; k < scan.cells(); ++k) {
        if (scan.state[k] != CellState::Valid) continue;
        const double range = scan.rangeMm[k];
        gray.levels[k] = levelOf(range);
        gray.saturated += range < gray.scale.nearMm || range > gray.scale.farMm ? 1U : 0U;
    }
}

void fillLogLevels(GrayImage& gray, const Scan& scan) {
    const std::array<double, 255> limits = logLimits(gray.scale);
    const auto search = [&](double range) {
        return static_cast<std::uint8_t>(std::upper_bound(limits.begin(), limits.end(), range) - limits.begin());
    };
    std::vector<std::uint8_t> table(static_cast<std::size_t>(std::min(static_cast<double>(kTableMm), gray.scale.farMm + 2)));
    for (std::size_t mm = 0; mm < table.size(); ++mm) table[mm] = search(static_cast<double>(mm));
    fillLevels(gray, scan, [&](double range) {
        const double floor = std::floor(range);
        return range == floor && floor >= 0 && floor < static_cast<double>(table.size()) ? table[static_cast<std::size_t>(floor)]
                                                                                         : search(range);
    });
}

} // namespace

GrayScale grayScale(const Scan& scan, const Settings& settings) {
    const bool logarithmic = settings.scaling == Scaling::Log;
    GrayScale scale;
    if (logarithmic) {
        scale = logScale(scan);
    } else {
        const RangeLimits limits = rangeLimits(scan);
        scale = {limits.minMm, limits.maxMm, false};
    }
    // As printed, c = 255 / (Smax - Smin) multiplies S itself: gray 0 lies at range 0.
    if (settings.scaling == Scaling::Thesis) return {0.0, scale.farMm - scale.nearMm, false};
    if (!std::isnan(settings.nearMm)) scale.nearMm = settings.nearMm;
    if (!std::isnan(settings.farMm)) scale.farMm = settings.farMm;
    if (logarithmic) scale.nearMm = std::max(1.0, scale.nearMm);
    scale.farMm = std::max(scale.nearMm, scale.farMm);
    return scale;
}

GrayImage grayImage(const Scan& scan, const Settings& settings) {
    GrayImage gray{Grid<std::uint8_t>(scan.lines(), scan.beams()), grayScale(scan, settings), 0};
    const double nearMm = gray.scale.nearMm;
    const double farMm = gray.scale.farMm;
    if (farMm <= nearMm) { // one single range, or a typed limit beyond the other: no depth, no gray
        fillLevels(gray, scan, [](double) { return std::uint8_t{0}; });
        return gray;
    }
    if (settings.scaling == Scaling::Log) {
        fillLogLevels(gray, scan);
    } else if (settings.scaling == Scaling::Thesis) {
        const double factor = kLevels / (farMm - nearMm);
        fillLevels(gray, scan, [&](double range) { return clampedLevel(range * factor); });
    } else {
        fillLevels(gray, scan, [&](double range) { return clampedLevel((range - nearMm) * kLevels / (farMm - nearMm)); });
    }
    return gray;
}

double mmPerLevel(const GrayScale& scale, double rangeMm) {
    if (scale.farMm <= scale.nearMm) return 0.0;
    if (scale.logarithmic) return rangeMm * std::log(scale.farMm / scale.nearMm) / kLevels;
    return (scale.farMm - scale.nearMm) / kLevels;
}

} // namespace edgescan
