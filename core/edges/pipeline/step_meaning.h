// The meaning of a threshold of the gray methods: the step in depth that just reaches it.
#pragma once

#include "core/base/result.h"
#include "core/edges/settings/settings.h"

#include <optional>
#include <string>
#include <string_view>

namespace edgescan::edges {

struct GrayScale;

/// Response of the method's kernels to a step of one gray level: along lines or beams, and diagonal. Computed by running smoothing and
/// detector on images of steps. {0, 0} for methods without gray levels.
struct StepGain {
    double straight = 0.0;
    double diagonal = 0.0;
};
[[nodiscard]] StepGain stepGain(const Settings& settings);

/// The smallest and the largest step that reach a threshold, over all directions of the step.
struct DepthStep {
    double smallestMm = 0.0; ///< mm; at referenceMm if `logarithmic`
    double largestMm = 0.0;
    double smallestPercent = 0.0; ///< percent of the range; only if `logarithmic`
    double largestPercent = 0.0;
    bool logarithmic = false;
    double referenceMm = 0.0; ///< geometric mean of near and far
};

/// Null if the scan has no depth or the method no gray levels. `threshold`: settings.lower or settings.upper().
[[nodiscard]] std::optional<DepthStep> depthStep(double threshold, const Settings& settings, const GrayScale& scale);

/// "0.13 to 0.19 m", or "0.9 to 1.3 % of range (45 to 65 mm at 5.0 m)".
[[nodiscard]] std::string depthStepText(const DepthStep& step);

/// "weak edge from a step of ..., strong from ...": the meaning of the thresholds of the settings; empty if they have no such meaning.
[[nodiscard]] std::string thresholdText(const Settings& settings, const GrayScale& scale);

/// A threshold typed as a depth: "0.5 m", "300mm", "5 %" (of the range; logarithmic gray levels only).
struct TypedStep {
    double value = 0.0; ///< mm or percent
    bool percent = false;
};
[[nodiscard]] std::optional<TypedStep> typedStep(std::string_view text);

/// The lower threshold that a straight step of this depth just reaches, to one decimal. In logarithmic gray levels a step in metres is
/// assumed at the middle of the window. Error: a method without gray levels, a scan without depth, percent without logarithmic levels, or a
/// threshold outside the limits of the table.
[[nodiscard]] Result<double> lowerOfStep(const TypedStep& step, const Settings& settings, const GrayScale& scale);

/// Strongest response of the method to flat surfaces that slant by up to a quarter of a gray level per cell. Only the rounding to whole
/// levels causes it, so thresholds below it cannot distinguish edges. 0 for methods without gray levels.
[[nodiscard]] double answerToRounding(const Settings& settings);

/// The lower threshold for `settings` that means the same step as that of `before`, so that a change of the method changes the picture
/// little; settings.lower if one of them has no gray levels. Canny starts an edge at its upper threshold and follows it down to the lower
/// one. A method with one threshold therefore gets the step in the middle between the two. Other methods never get a threshold below
/// answerToRounding().
[[nodiscard]] double lowerWithSameStep(const Settings& before, const Settings& settings);

} // namespace edgescan::edges
