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

Gradient gradientOf(const Detection& detection) {
    const Settings& settings = detection.settings;
    if (settings.method == Method::LogRange) return logRangeGradient(*detection.scan, settings);
    const Grid<std::uint8_t> masked = maskedCells(*detection.scan, settings);
    return sobelGradient(*detection.smoothed, masked.size() > 0 ? &masked : nullptr, settings.aperture);
}

ThresholdMap thresholdMapOf(const Detection& detection) {
    const Settings& settings = detection.settings;
    if (settings.method == Method::LogRange) return logRangeThresholdMap(*detection.scan, settings);
    if (settings.method == Method::Canny) return cannyThresholdMap(gradientOf(detection), settings);
    if (hasOneThreshold(settings.method)) {
        const Grid<std::uint8_t> masked = maskedCells(*detection.scan, settings);
        const Grid<std::uint8_t>& levels = detection.smoothed ? *detection.smoothed : detection.gray->levels;
        return responseThresholdMap(detectorResponse(settings.method, levels, masked.size() > 0 ? &masked : nullptr, settings));
    }
    const DepthEdgeSettings depth = depthEdgeSettings(settings);
    const DepthResponses responses = detection.responses ? *detection.responses : depthResponses(*detection.scan, depth);
    ThresholdMap map = linkedThresholdMap(decideDepthEdges(responses, depth).strength, depth.hysteresisLow, depth.minimumLength);
    if (depth.border) {
        for (const std::uint32_t k : responses.border) map.highest[k] = std::numeric_limits<double>::infinity();
    }
    return map;
}

} // namespace edgescan
