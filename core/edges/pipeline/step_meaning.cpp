// The meaning of a threshold as a step in depth.
#include "core/edges/pipeline/step_meaning.h"

#include "core/base/number_text.h"
#include "core/edges/gray/gray.h"
#include "core/edges/gray/smooth.h"
#include "core/edges/pipeline/methods.h"
#include "core/edges/settings/method_traits.h"
#include "core/edges/settings/parameters.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace edgescan::edges {
namespace {

constexpr int kStep = 240; // levels; a multiple of 16, so that the 3 x 3 Gaussian rounds no value
constexpr int kDark = 8;

bool smoothsFirst(const Settings& settings) { return reads(settings.method, kReadsKernel); }

// Response of every cell of an image.
Grid<float> responseOf(const Grid<std::uint8_t>& picture, const Settings& settings) {
    return rowOf(settings.method).response(smoothsFirst(settings) ? smooth(picture, settings) : picture, nullptr, settings);
}

// The largest distance of a cell that influences the response.
int reachOf(const Settings& settings) {
    if (smoothsFirst(settings)) return settings.kernel + settings.aperture + 4;
    return static_cast<int>(std::ceil(4 * (std::isnan(settings.sigma) ? automaticSigma(settings) : settings.sigma))) + 4;
}

// Strongest response near the middle of a square image of a step.
double answer(const Grid<std::uint8_t>& picture, const Settings& settings) {
    const Grid<float> response = responseOf(picture, settings);
    const int middle = picture.lines / 2;
    float strongest = 0;
    for (int i = middle - 2; i <= middle + 2; ++i) {
        for (int j = middle - 2; j <= middle + 2; ++j) strongest = std::max(strongest, response.at(i, j));
    }
    return strongest / static_cast<double>(kStep);
}

bool hasGrayLevels(const Settings& settings) { return reads(settings.method, kReadsGray); }

std::string number(double value, int significant) {
    const int before = value > 0 ? static_cast<int>(std::floor(std::log10(value))) + 1 : 1;
    return fixedText(value, std::clamp(significant - before, 0, 6));
}

std::string millimetres(double from, double to) {
    if (to < 100.0) return number(from, 2) + " to " + number(to, 2) + " mm";
    return number(from / 1000, 2) + " to " + number(to / 1000, 2) + " m";
}

double percentOf(double levels, const GrayScale& scale) { return 100.0 * std::expm1(levels * mmPerLevel(scale, 1.0)); }

} // namespace

StepGain stepGain(const Settings& settings) {
    if (!hasGrayLevels(settings)) return {};
    const int reach = reachOf(settings);
    const int size = 2 * reach + 1;
    Grid<std::uint8_t> straight(size, size);
    Grid<std::uint8_t> diagonal(size, size);
    for (int i = 0; i < size; ++i) {
        for (int j = 0; j < size; ++j) {
            straight.at(i, j) = static_cast<std::uint8_t>(j > reach ? kDark + kStep : kDark);
            diagonal.at(i, j) = static_cast<std::uint8_t>(j > i ? kDark + kStep : kDark);
        }
    }
    return {answer(straight, settings), answer(diagonal, settings)};
}

std::optional<DepthStep> depthStep(double threshold, const Settings& settings, const GrayScale& scale) {
    const StepGain gain = stepGain(settings);
    if (gain.straight <= 0 || gain.diagonal <= 0 || scale.farMm <= scale.nearMm) return std::nullopt;
    const double few = threshold / std::max(gain.straight, gain.diagonal);
    const double many = threshold / std::min(gain.straight, gain.diagonal);
    DepthStep step;
    step.logarithmic = scale.logarithmic;
    if (!scale.logarithmic) {
        step.smallestMm = few * mmPerLevel(scale, 0);
        step.largestMm = many * mmPerLevel(scale, 0);
        return step;
    }
    step.referenceMm = std::sqrt(scale.nearMm * scale.farMm);
    step.smallestPercent = percentOf(few, scale);
    step.largestPercent = percentOf(many, scale);
    step.smallestMm = step.referenceMm * step.smallestPercent / 100;
    step.largestMm = step.referenceMm * step.largestPercent / 100;
    return step;
}

std::string depthStepText(const DepthStep& step) {
    const std::string length = millimetres(step.smallestMm, step.largestMm);
    if (!step.logarithmic) return length;
    return number(step.smallestPercent, 2) + " to " + number(step.largestPercent, 2) + " % of range (" + length + " at " +
           number(step.referenceMm / 1000, 2) + " m)";
}

std::string thresholdText(const Settings& settings, const GrayScale& scale) {
    const auto lower = depthStep(settings.lower, settings, scale);
    if (!lower) return {};
    if (hasOneThreshold(settings.method)) return "edge from a step of " + depthStepText(*lower);
    const auto upper = depthStep(settings.upper(), settings, scale);
    return "weak edge from a step of " + depthStepText(*lower) + ", strong from " + depthStepText(*upper);
}

std::optional<TypedStep> typedStep(std::string_view text) {
    double factor = 0;
    TypedStep step;
    const auto ends = [&](std::string_view unit, double times) {
        if (factor != 0 || !text.ends_with(unit)) return;
        text.remove_suffix(unit.size());
        factor = times;
    };
    ends("%", 1.0);
    step.percent = factor != 0;
    ends("mm", 1.0);
    ends("cm", 10.0);
    ends("m", 1000.0);
    if (factor == 0) return std::nullopt;
    while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
    while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), step.value);
    if (code != std::errc{} || end != text.data() + text.size() || !std::isfinite(step.value) || step.value < 0) return std::nullopt;
    step.value *= factor;
    return step;
}

Result<double> lowerOfStep(const TypedStep& step, const Settings& settings, const GrayScale& scale) {
    const Parameter& parameter = *findParameter("lower");
    const StepGain gain = stepGain(settings);
    if (gain.straight <= 0)
        return Error{"this method has no gray levels, so its threshold is not a depth", "--lower", "choose a method such as canny"};
    if (scale.farMm <= scale.nearMm)
        return Error{"the scan has no depth, so no threshold corresponds to one", "--lower", "give the threshold as a plain number"};
    if (step.percent && !scale.logarithmic)
        return Error{"a share of the range has one threshold only in logarithmic gray levels", "--lower", "give metres, or --scaling log"};
    double levels = 0;
    if (scale.logarithmic) {
        const double share = step.percent ? step.value / 100 : step.value / std::sqrt(scale.nearMm * scale.farMm);
        levels = std::log1p(share) / mmPerLevel(scale, 1.0);
    } else {
        levels = step.value / mmPerLevel(scale, 0);
    }
    const double lower = std::round(10.0 * levels * gain.straight) / 10.0;
    if (lower <= parameter.maximum) return lower;
    return Error{"a step of this depth is beyond the largest threshold", "--lower", "give a smaller depth"};
}

double answerToRounding(const Settings& settings) {
    if (!hasGrayLevels(settings)) return 0.0;
    constexpr int kParts = 8; // parts of a level
    const int reach = reachOf(settings);
    const int size = 2 * (reach + kParts) + 1; // the pattern of the rounding repeats after this many cells
    double strongest = 0;
    for (int alongLines = 0; alongLines <= kParts / 4; ++alongLines) {
        for (int alongBeams = 0; alongBeams <= kParts / 4; ++alongBeams) {
            Grid<std::uint8_t> plane(size, size);
            for (int i = 0; i < size; ++i) {
                for (int j = 0; j < size; ++j)
                    plane.at(i, j) = static_cast<std::uint8_t>(kDark + (alongLines * i + alongBeams * j) / kParts);
            }
            const Grid<float> response = responseOf(plane, settings);
            for (int i = reach; i < size - reach; ++i) {
                for (int j = reach; j < size - reach; ++j) strongest = std::max(strongest, static_cast<double>(response.at(i, j)));
            }
        }
    }
    return strongest;
}

double lowerWithSameStep(const Settings& before, const Settings& settings) {
    const double from = stepGain(before).straight;
    const double to = stepGain(settings).straight;
    if (from <= 0 || to <= 0) return settings.lower;
    const bool bothTwo = !hasOneThreshold(before.method) && !hasOneThreshold(settings.method);
    // The factor of the lower threshold that makes the two comparable.
    const auto compared = [&](const Settings& s) { return hasOneThreshold(s.method) ? 1.0 : bothTwo ? s.ratio : 0.5 * (1.0 + s.ratio); };
    const double lower = before.lower * compared(before) / from * to / compared(settings);
    const bool changed = before.method != settings.method; // otherwise the threshold was chosen for this method
    const double least = changed && hasOneThreshold(settings.method) ? answerToRounding(settings) : 0.0;
    return snapped(*findParameter("lower"), std::max(lower, least));
}

} // namespace edgescan::edges
