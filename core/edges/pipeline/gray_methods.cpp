// The methods on gray levels, and Canny on log range: their decisions, and their values at one cell.
#include "core/edges/gray/canny.h"
#include "core/edges/gray/gradient.h"
#include "core/edges/gray/gray.h"
#include "core/edges/gray/log_range.h"
#include "core/edges/pipeline/methods.h"

#include <cmath>
#include <numbers>

namespace edgescan::edges {
namespace {

const Grid<std::uint8_t>& levelsOf(const Detection& detection) { return detection.smoothed ? *detection.smoothed : detection.gray->levels; }

bool isMasked(const Detection& detection, std::size_t k) { return detection.masked && (*detection.masked)[k] != 0; }

Gradient cannyGradient(const Detection& detection) {
    return sobelGradient(levelsOf(detection), detection.masked.get(), detection.settings.aperture);
}

FoundEdges cannyEdges(const Detection& detection) {
    const Grid<std::uint8_t>& levels = levelsOf(detection);
    return {detection.masked ? cannyAroundHoles(levels, *detection.masked, detection.settings) : canny(levels, detection.settings)};
}

// `toGradient`: from the swept threshold to a threshold of the gradient.
template <class ToGradient>
EdgeLevels gradientLevels(const Gradient& gradient, const Settings& settings, const std::vector<double>& thresholds,
                          ToGradient toGradient) {
    std::vector<double> weak, strong;
    for (const double threshold : thresholds) {
        weak.push_back(magnitudeLimit(toGradient(threshold), gradient.scale, settings.norm));
        strong.push_back(magnitudeLimit(settings.ratio * toGradient(threshold), gradient.scale, settings.norm));
    }
    return edgeLevels(suppressedMagnitude(gradient, settings.norm), std::move(weak), std::move(strong));
}

EdgeLevels cannyLevels(const Detection& detection, const std::vector<double>& thresholds) {
    return gradientLevels(cannyGradient(detection), detection.settings, thresholds, [](double threshold) { return threshold; });
}

EdgeLevels logRangeLevels(const Detection& detection, const std::vector<double>& thresholds) {
    const Settings& settings = detection.settings;
    EdgeLevels levels = gradientLevels(logRangeGradient(*detection.scan, settings), settings, thresholds,
                                       [&](double percent) { return logRangeGradientOfStep(percent, settings); });
    const Grid<std::uint8_t> without = withoutOwnRange(*detection.scan);
    for (std::size_t k = 0; k < without.size(); ++k) {
        if (without[k] != 0 && levels.weak[k] > 0) levels.apart.push_back(static_cast<std::uint32_t>(k));
    }
    return levels;
}

double sizeOf(const Gradient& gradient, std::int32_t magnitude, Norm norm) {
    return (norm == Norm::L2 ? std::sqrt(static_cast<double>(magnitude)) : magnitude) / gradient.scale;
}

Judgement judgeGradient(Gradient gradient, double lower, const Settings& settings, std::size_t k) {
    Judgement found;
    found.lower = lower;
    found.upper = settings.ratio * lower;
    const auto strengthAt = [&](std::size_t n) {
        return sizeOf(gradient, gradientMagnitude(gradient.alongBeams[n], gradient.alongLines[n], settings.norm), settings.norm);
    };
    const std::int16_t dx = gradient.alongBeams[k];
    const std::int16_t dy = gradient.alongLines[k];
    found.alongBeams = dx / gradient.scale;
    found.alongLines = dy / gradient.scale;
    found.strength = strengthAt(k);
    if (dx != 0 || dy != 0) found.directionDeg = std::atan2(dy, dx) * 180.0 / std::numbers::pi;
    const AlongGradient along = alongGradient(dx, dy);
    const auto beams = static_cast<std::size_t>(gradient.alongBeams.beams);
    for (const int sign : {-1, 1}) {
        const int line = static_cast<int>(k / beams) + sign * along.lineStep;
        const int beam = static_cast<int>(k % beams) + sign * along.beamStep;
        if (found.suppressedBy || !gradient.alongBeams.contains(line, beam)) continue;
        const double other = strengthAt(gradient.alongBeams.index(line, beam));
        const bool outdone = sign > 0 && along.tieSurvives ? found.strength >= other : found.strength > other;
        if (!outdone && other > found.lower) found.suppressedBy = CellStrength{line, beam, other};
    }
    found.linked = [shared = std::make_shared<const Gradient>(std::move(gradient)), norm = settings.norm](std::size_t n) {
        return static_cast<float>(sizeOf(*shared, suppressedMagnitudeAt(*shared, norm, n), norm));
    };
    found.compared = found.strength;
    return found;
}

Judgement judgeCanny(const Detection& detection, std::size_t k) {
    Judgement found = judgeGradient(cannyGradient(detection), detection.settings.lower, detection.settings, k);
    found.takesPart = !isMasked(detection, k);
    return found;
}

// Converts gradients of the logarithm to steps in percent of the range, the unit of the threshold.
double inPercent(double gradient, const Settings& settings) {
    return std::copysign(logRangeStepOfGradient(std::abs(gradient), settings), gradient);
}

Judgement judgeLogRange(const Detection& detection, std::size_t k) {
    const Settings& settings = detection.settings;
    Judgement found =
        judgeGradient(logRangeGradient(*detection.scan, settings), logRangeGradientOfStep(settings.stepPercent, settings), settings, k);
    found.takesPart = withoutOwnRange(*detection.scan)[k] == 0;
    found.shown = inPercent;
    return found;
}

Grid<float> responseOf(const Detection& detection) {
    return rowOf(detection.settings.method).response(levelsOf(detection), detection.masked.get(), detection.settings);
}

FoundEdges detectorEdges(const Detection& detection) {
    const Grid<float> response = responseOf(detection);
    Grid<std::uint8_t> mask(response.lines, response.beams);
    for (std::size_t k = 0; k < mask.size(); ++k) mask[k] = static_cast<double>(response[k]) > detection.settings.lower ? 255 : 0;
    return {std::move(mask)};
}

Judgement judgeDetector(const Detection& detection, std::size_t k) {
    Judgement found;
    found.takesPart = !isMasked(detection, k);
    found.strength = responseOf(detection)[k];
    found.lower = found.upper = detection.settings.lower;
    const auto beams = static_cast<std::size_t>(detection.scan->beams());
    const auto direction = rowOf(detection.settings.method).direction;
    if (direction == nullptr || !found.takesPart) return found;
    const MaskDirection way =
        direction(neighboursAt(levelsOf(detection), detection.masked.get(), static_cast<int>(k / beams), static_cast<int>(k % beams)));
    found.alongBeams = way.alongBeams;
    found.alongLines = way.alongLines;
    found.directionDeg = way.deg;
    return found;
}

} // namespace

Grid<float> cannyResponse(const Grid<std::uint8_t>& levels, const Grid<std::uint8_t>* missing, const Settings& settings) {
    const Gradient gradient = sobelGradient(levels, missing, settings.aperture);
    Grid<float> response(levels.lines, levels.beams);
    for (std::size_t k = 0; k < response.size(); ++k) {
        const std::int32_t magnitude = gradientMagnitude(gradient.alongBeams[k], gradient.alongLines[k], settings.norm);
        response[k] = static_cast<float>(sizeOf(gradient, magnitude, settings.norm));
    }
    return response;
}

const Decision kCannyDecision{
    "canny",
    cannyEdges,
    [](const Detection& detection) { return cannyThresholdMap(cannyGradient(detection), detection.settings); },
    cannyLevels,
    [](const Detection& detection, std::size_t k) { return cannyThresholdAt(cannyGradient(detection), detection.settings, k); },
    judgeCanny};

const Decision kLogRangeDecision{
    "log range",
    [](const Detection& detection) { return FoundEdges{logRangeEdges(*detection.scan, detection.settings)}; },
    [](const Detection& detection) { return logRangeThresholdMap(*detection.scan, detection.settings); },
    logRangeLevels,
    [](const Detection& detection, std::size_t k) { return logRangeThresholdAt(*detection.scan, detection.settings, k); },
    judgeLogRange};

const Decision kDetectorDecision{"detector",
                                 detectorEdges,
                                 [](const Detection& detection) { return responseThresholdMap(responseOf(detection)); },
                                 [](const Detection& detection, const std::vector<double>& thresholds) {
                                     return edgeLevels(responseOf(detection), thresholds, thresholds);
                                 },
                                 [](const Detection& detection, std::size_t k) { return responseThresholdAt(responseOf(detection), k); },
                                 judgeDetector};

} // namespace edgescan::edges
