// Every threshold of a frame's method.
#include "core/method/detection_thresholds.h"

#include "core/depth/depth_settings.h"
#include "core/gray/detector.h"
#include "core/gray/log_range.h"
#include "core/gray/masked_cells.h"
#include "core/scan/missing_cells.h"
#include "core/settings/method_traits.h"
#include "core/settings/parameters.h"

#include <limits>

namespace edgescan {

const char* sweptParameter(Method method) {
    if (method == Method::LogRange) return "step";
    return method == Method::Canny || hasOneThreshold(method) ? "lower" : "sensitivity";
}

bool sameThresholdMap(const Settings& a, const Settings& b) {
    if (a.method != b.method) return false;
    const Parameter& swept = *findParameter(sweptParameter(a.method));
    Settings like = a;
    swept.set(like, swept.get(b));
    return like == b;
}

Gradient gradientOf(const Frame& frame) {
    const Settings& settings = frame.settings;
    if (settings.method == Method::LogRange) return logRangeGradient(*frame.scan, settings);
    const Grid<std::uint8_t> masked = maskedCells(*frame.scan, settings);
    return sobelGradient(*frame.smoothed, masked.size() > 0 ? &masked : nullptr, settings.aperture);
}

ThresholdMap thresholdMapOf(const Frame& frame) {
    const Settings& settings = frame.settings;
    if (settings.method == Method::LogRange) return logRangeThresholdMap(*frame.scan, settings);
    if (settings.method == Method::Canny) return cannyThresholdMap(gradientOf(frame), settings);
    if (hasOneThreshold(settings.method)) {
        const Grid<std::uint8_t> masked = maskedCells(*frame.scan, settings);
        const Grid<std::uint8_t>& levels = frame.smoothed ? *frame.smoothed : frame.gray->levels;
        return responseThresholdMap(detectorResponse(settings.method, levels, masked.size() > 0 ? &masked : nullptr, settings));
    }
    const DepthEdgeSettings depth = depthEdgeSettings(settings);
    const DepthResponses responses = frame.responses ? *frame.responses : depthResponses(*frame.scan, depth);
    ThresholdMap map = linkedThresholdMap(decideDepthEdges(responses, depth).strength, depth.hysteresisLow, depth.minimumLength);
    if (depth.border) {
        for (const std::uint32_t k : responses.border) map.highest[k] = std::numeric_limits<double>::infinity();
    }
    return map;
}

} // namespace edgescan
