// Range to gray.
#include "core/edges/gray.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace edgescan {
namespace {

constexpr double kLevels = 255.0;
constexpr double kLowPercentile = 0.01;

// 1 % and 99 % of the valid ranges, not closer together than what makes one gray level one sigma of the range noise.
GrayScale percentileScale(const Scan& scan) {
    std::vector<float> ranges;
    ranges.reserve(scan.cells());
    for (std::size_t k = 0; k < scan.cells(); ++k) {
        if (scan.state[k] == CellState::Valid) ranges.push_back(scan.rangeMm[k]);
    }
    if (ranges.empty()) return {};
    const auto trimmed = static_cast<std::ptrdiff_t>(kLowPercentile * static_cast<double>(ranges.size() - 1));
    const auto low = ranges.begin() + trimmed;
    const auto high = ranges.end() - 1 - trimmed;
    std::nth_element(ranges.begin(), low, ranges.end());
    std::nth_element(low, high, ranges.end());
    GrayScale scale{*low, *high, 0.0};
    const double smallestSpan = kLevels * std::max(rangeNoiseMm(scan), scan.unitMm);
    const double missingSpan = smallestSpan - (scale.farMm - scale.nearMm);
    if (missingSpan > 0) {
        scale.nearMm = std::max(0.0, scale.nearMm - missingSpan / 2);
        scale.farMm = scale.nearMm + smallestSpan;
    }
    return scale;
}

// thesis: c = 255 / (Smax - Smin), rint(S c): gray 0 lies at range 0.
std::uint8_t thesisLevel(double rangeMm, double factor) {
    return static_cast<std::uint8_t>(std::clamp(std::nearbyint(rangeMm * factor), 0.0, kLevels));
}

std::uint8_t windowLevel(double rangeMm, const GrayScale& scale) {
    const double level = std::nearbyint((rangeMm - scale.nearMm) * kLevels / (scale.farMm - scale.nearMm));
    return static_cast<std::uint8_t>(std::clamp(level, 0.0, kLevels));
}

} // namespace

double rangeNoiseMm(const Scan& scan) {
    std::vector<float> differences;
    differences.reserve(scan.cells());
    for (int i = 0; i < scan.lines(); ++i) {
        const float* range = scan.rangeMm.line(i);
        const CellState* state = scan.state.line(i);
        for (int j = 1; j + 1 < scan.beams(); ++j) {
            if (state[j - 1] != CellState::Valid || state[j] != CellState::Valid || state[j + 1] != CellState::Valid) continue;
            differences.push_back(std::abs(range[j - 1] - 2.0F * range[j] + range[j + 1]));
        }
    }
    if (differences.empty()) return 0.0;
    const auto middle = differences.begin() + static_cast<std::ptrdiff_t>(differences.size() / 2);
    std::nth_element(differences.begin(), middle, differences.end());
    return *middle / (0.6745 * std::sqrt(6.0));
}

GrayScale grayScale(const Scan& scan, const Settings& settings) {
    GrayScale scale;
    if (settings.scaling == Scaling::Percentile && (std::isnan(settings.nearMm) || std::isnan(settings.farMm))) {
        scale = percentileScale(scan);
    } else {
        const RangeLimits limits = rangeLimits(scan);
        scale = {limits.minMm, limits.maxMm, 0.0};
    }
    if (settings.scaling == Scaling::Thesis) {
        scale = {0.0, scale.farMm - scale.nearMm, 0.0};
    } else {
        if (!std::isnan(settings.nearMm)) scale.nearMm = settings.nearMm;
        if (!std::isnan(settings.farMm)) scale.farMm = settings.farMm;
        scale.farMm = std::max(scale.nearMm, scale.farMm);
    }
    scale.mmPerLevel = (scale.farMm - scale.nearMm) / kLevels;
    return scale;
}

GrayImage grayImage(const Scan& scan, const Settings& settings) {
    GrayImage gray{Grid<std::uint8_t>(scan.lines(), scan.beams()), grayScale(scan, settings), 0};
    const GrayScale& scale = gray.scale;
    if (scale.farMm <= scale.nearMm) return gray; // one single range: no depth, no gray
    const bool thesis = settings.scaling == Scaling::Thesis;
    const double factor = kLevels / (scale.farMm - scale.nearMm);
    for (std::size_t k = 0; k < scan.cells(); ++k) {
        if (scan.state[k] != CellState::Valid) continue;
        const double range = scan.rangeMm[k];
        gray.levels[k] = thesis ? thesisLevel(range, factor) : windowLevel(range, scale);
        gray.saturated += range < scale.nearMm || range > scale.farMm ? 1U : 0U;
    }
    return gray;
}

} // namespace edgescan
