// The one table of methods: what each of them does. What it is called and which settings it reads: core/edges/settings/method_traits.h.
#pragma once

#include "core/edges/gray/gradient_masks.h"
#include "core/edges/gray/threshold_map.h"
#include "core/edges/pipeline/detection.h"
#include "core/edges/pipeline/judgement.h"

namespace edgescan {

struct FoundEdges {
    Grid<std::uint8_t> mask;   ///< lines x beams, 255 = edge
    Grid<DepthEdge> classes{}; ///< lines x beams; empty where the method tells no classes apart
};

/// How edges are decided. Of the detection the scan, the settings and what the stages before Stage::Edges made is there.
struct Decision {
    const char* stage; ///< name of its time
    FoundEdges (*edges)(const Detection& detection);
    /// Every value of sweptParameter() at once, all other settings as they are. As costly as the edges.
    ThresholdMap (*thresholds)(const Detection& detection);
    Judgement (*judge)(const Detection& detection, std::size_t k);
};

struct MethodRow {
    Method method;
    const Decision& decision;
    /// To gray levels, in units of the thresholds: lines x beams. Null for a method without gray levels. `missing` may be null.
    Grid<float> (*response)(const Grid<std::uint8_t>& levels, const Grid<std::uint8_t>* missing, const Settings& settings);
    MaskDirection (*direction)(const Neighbours& at); ///< null where the response has none of its own
};

[[nodiscard]] const MethodRow& rowOf(Method method);

/// The rows' decisions: gray_methods.cpp, surface_methods.cpp.
extern const Decision kCannyDecision, kLogRangeDecision, kDetectorDecision, kSurfaceDecision;

/// The gradient that Canny suppresses, as a response.
[[nodiscard]] Grid<float> cannyResponse(const Grid<std::uint8_t>& levels, const Grid<std::uint8_t>* missing, const Settings& settings);

/// Every threshold of a detection's method at once, all other settings as they are. As costly as a run of the method.
[[nodiscard]] inline ThresholdMap thresholdMapOf(const Detection& detection) {
    return rowOf(detection.settings.method).decision.thresholds(detection);
}

} // namespace edgescan
