// What a threshold of the gray methods stands for: the step in depth that just reaches it.
#pragma once

#include "core/base/result.h"
#include "core/edges/gray/gray.h"
#include "core/edges/settings/settings.h"

#include <optional>
#include <string>
#include <string_view>

namespace edgescan {

/// Answer of the method's kernels to a step of one gray level: along lines or beams, and diagonal. Worked out by running smoothing and
/// detector on pictures of steps. {0, 0} for methods without gray levels.
struct StepGain {
    double straight = 0.0;
    double diagonal = 0.0;
};
[[nodiscard]] StepGain stepGain(const Settings& settings);

/// The steps between which a threshold is reached, whatever way the step runs.
struct DepthStep {
    double smallestMm = 0.0; ///< at referenceMm where `logarithmic`
    double largestMm = 0.0;
    double smallestPercent = 0.0; ///< of the range; only where `logarithmic`
    double largestPercent = 0.0;
    bool logarithmic = false;
    double referenceMm = 0.0; ///< geometric middle of near and far
};

/// Null when the scan has no depth or the method no gray levels. `threshold`: settings.lower or settings.upper().
[[nodiscard]] std::optional<DepthStep> depthStep(double threshold, const Settings& settings, const GrayScale& scale);

/// "0.13 to 0.19 m", or "0.9 to 1.3 % of range (45 to 65 mm at 5.0 m)".
[[nodiscard]] std::string depthStepText(const DepthStep& step);

/// "weak edge from a step of ..., strong from ...": what the thresholds of the settings stand for; empty when there is nothing to say.
[[nodiscard]] std::string thresholdText(const Settings& settings, const GrayScale& scale);

/// A threshold typed as a depth: "0.5 m", "300mm", "5 %" (of the range; logarithmic gray levels only). Null for anything else.
struct TypedStep {
    double value = 0.0; ///< mm or percent
    bool percent = false;
};
[[nodiscard]] std::optional<TypedStep> typedStep(std::string_view text);

/// The lower threshold that a straight step of this depth just reaches, to one decimal; in logarithmic gray levels a step in metres is
/// taken at the middle of the window. Error: a method without gray levels, a scan without depth, percent without logarithmic levels, or a
/// threshold beyond the limits of the table.
[[nodiscard]] Result<double> lowerOfStep(const TypedStep& step, const Settings& settings, const GrayScale& scale);

/// Strongest answer of the method to flat surfaces that slant by up to a quarter of a gray level per cell: nothing but the rounding to
/// whole levels makes it, so no threshold below it tells an edge from none. 0 for methods without gray levels.
[[nodiscard]] double answerToRounding(const Settings& settings);

/// The lower threshold for `settings` that means the same step as those of `before`, for changing the method without changing what is seen;
/// settings.lower where one of them has no gray levels. Canny starts an edge at its upper threshold and follows it down to the lower one: a
/// method with one threshold gets the step in the middle between the two, and another method never one below answerToRounding().
[[nodiscard]] double lowerWithSameStep(const Settings& before, const Settings& settings);

} // namespace edgescan
