// Converts the operator's settings to those of EdgeScan+.
#include "core/edges/edgescan_plus/plus_settings.h"

#include "core/edges/settings/method_traits.h"
#include "core/edges/settings/parameters.h"

#include <cmath>

namespace edgescan::edges {

DepthEdgeSettings depthEdgeSettings(const Settings& settings) {
    const int classes = reads(settings.method, kReadsClasses) ? settings.classes : traitsOf(settings.method).classes;
    DepthEdgeSettings depth;
    if (!std::isnan(settings.jumpMm)) depth.jumpMm = settings.jumpMm;
    depth.jumpGrowth = settings.growthPercent / 100.0;
    depth.creaseDeg = settings.creaseDeg;
    depth.sensitivity = settings.sensitivity;
    depth.hysteresisLow = settings.hysteresisPercent / 100.0;
    depth.minimumLength = settings.minimumLength;
    depth.grazing = settings.grazing;
    depth.straighten = settings.straighten;
    if (!std::isnan(settings.noiseMm)) depth.noiseAt5mMm = settings.noiseMm;
    depth.noiseKind = settings.noiseKind;
    depth.jumps = (classes & kClassJump) != 0;
    depth.convex = (classes & kClassConvex) != 0;
    depth.concave = (classes & kClassConcave) != 0;
    depth.border = (classes & kClassBorder) != 0;
    depth.silhouettes = (classes & kClassSilhouette) != 0;
    return depth;
}

const char* edgeClassName(DepthEdge kind) {
    static constexpr const char* kNames[]{"none", "jump", "convex", "concave", "border", "silhouette"};
    return kNames[static_cast<std::size_t>(kind)];
}

const char* edgeClassLabel(DepthEdge kind) {
    return kind == DepthEdge::None ? "none" : findParameter("classes")->choices[static_cast<std::size_t>(kind) - 1].label;
}

} // namespace edgescan::edges
