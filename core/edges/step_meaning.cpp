// What a threshold stands for.
#include "core/edges/step_meaning.h"

#include "core/edges/detectors/detector.h"
#include "core/edges/detectors/zero_crossings.h"
#include "core/edges/gradient.h"
#include "core/edges/parameters.h"
#include "core/edges/smooth.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>

namespace edgescan {
namespace {

constexpr int kStep = 240; // levels; a multiple of 16, so that the 3 x 3 Gaussian rounds nothing
constexpr int kDark = 8;

// Strongest answer near the middle of a square picture of a step.
double answer(const Grid<std::uint8_t>& picture, const Settings& settings) {
    Grid<float> response;
    if (settings.method == Method::Canny) {
        const Gradient gradient = sobelGradient(smooth(picture, settings), nullptr, settings.aperture);
        response = Grid<float>(picture.lines, picture.beams);
        for (std::size_t k = 0; k < response.size(); ++k) {
            const std::int32_t magnitude = gradientMagnitude(gradient.alongBeams[k], gradient.alongLines[k], settings.norm);
            const double size = settings.norm == Norm::L2 ? std::sqrt(static_cast<double>(magnitude)) : magnitude;
            response[k] = static_cast<float>(size / gradient.scale);
        }
    } else {
        response =
            detectorResponse(settings.method, smoothsItself(settings.method) ? picture : smooth(picture, settings), nullptr, settings);
    }
    const int middle = picture.lines / 2;
    float strongest = 0;
    for (int i = middle - 2; i <= middle + 2; ++i) {
        for (int j = middle - 2; j <= middle + 2; ++j) strongest = std::max(strongest, response.at(i, j));
    }
    return strongest / static_cast<double>(kStep);
}

bool hasGrayLevels(const Settings& settings) { return settings.method == Method::Canny || hasOneThreshold(settings.method); }

std::string number(double value, int significant) {
    std::array<char, 32> text{};
    const int before = value > 0 ? static_cast<int>(std::floor(std::log10(value))) + 1 : 1;
    std::snprintf(text.data(), text.size(), "%.*f", std::clamp(significant - before, 0, 6), value);
    return text.data();
}

std::string millimetres(double from, double to) {
    if (to < 100.0) return number(from, 2) + " to " + number(to, 2) + " mm";
    return number(from / 1000, 2) + " to " + number(to / 1000, 2) + " m";
}

double percentOf(double levels, const GrayScale& scale) { return 100.0 * std::expm1(levels * mmPerLevel(scale, 1.0)); }

} // namespace

StepGain stepGain(const Settings& settings) {
    if (!hasGrayLevels(settings)) return {};
    const double sigma = std::isnan(settings.sigma) ? kMarrHildrethSigma : settings.sigma;
    const int reach = smoothsItself(settings.method) ? static_cast<int>(std::ceil(4 * sigma)) + 4 : settings.kernel + settings.aperture + 4;
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
        return Error{"this method has no gray levels, so a depth is no threshold of it", "--lower", "choose a method such as canny"};
    if (scale.farMm <= scale.nearMm)
        return Error{"the scan has no depth, so no threshold stands for one", "--lower", "give the threshold as a plain number"};
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

double lowerWithSameStep(const Settings& before, const Settings& settings) {
    const double from = stepGain(before).straight;
    const double to = stepGain(settings).straight;
    if (from <= 0 || to <= 0) return settings.lower;
    // Canny starts an edge at its upper threshold.
    const auto starts = [](const Settings& s) { return s.method == Method::Canny ? s.ratio : 1.0; };
    const double levels = before.lower * starts(before) / from;
    return snapped(*findParameter("lower"), levels * to / starts(settings));
}

} // namespace edgescan
