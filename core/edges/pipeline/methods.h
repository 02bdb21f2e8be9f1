// The table of methods: the functions of each method. Names and settings are in core/edges/settings/method_traits.h.
#pragma once

#include "core/edges/gray/gradient_masks.h"
#include "core/edges/pipeline/detection.h"
#include "core/edges/pipeline/edge_levels.h"
#include "core/edges/pipeline/judgement.h"
#include "core/edges/pipeline/threshold_map.h"

namespace edgescan::edges {

struct FoundEdges {
    Grid<std::uint8_t> mask;   ///< lines x beams, 255 = edge
    Grid<DepthEdge> classes{}; ///< lines x beams; empty if the method does not distinguish classes
};

/// How a method decides on edges. The detection holds the scan, the settings and the results of the stages before Stage::Edges.
struct Decision {
    const char* stage; ///< name of the stage in the timings
    FoundEdges (*edges)(const Detection& detection);
    /// The map for all values of sweptParameter(), with all other settings unchanged. Costs several times as much as the edges.
    ThresholdMap (*thresholds)(const Detection& detection);
    /// The levels of the cells for these values of sweptParameter(), ascending: a part of the map in a part of the time.
    EdgeLevels (*levels)(const Detection& detection, const std::vector<double>& thresholds);
    /// The value of the map at one cell, without the memory for the map.
    double (*threshold)(const Detection& detection, std::size_t k);
    Judgement (*judge)(const Detection& detection, std::size_t k);
};

struct MethodRow {
    Method method;
    const Decision& decision;
    /// Response to gray levels, in units of the thresholds: lines x beams. Null for a method without gray levels. `missing` may be null.
    Grid<float> (*response)(const Grid<std::uint8_t>& levels, const Grid<std::uint8_t>* missing, const Settings& settings);
    MaskDirection (*direction)(const Neighbours& at); ///< null if the response has no direction of its own
};

[[nodiscard]] const MethodRow& rowOf(Method method);

/// The decisions of the rows: gray_methods.cpp, surface_methods.cpp.
extern const Decision kCannyDecision, kLogRangeDecision, kDetectorDecision, kSurfaceDecision;

/// The gradient to which Canny applies suppression, as a response.
[[nodiscard]] Grid<float> cannyResponse(const Grid<std::uint8_t>& levels, const Grid<std::uint8_t>* missing, const Settings& settings);

/// The threshold map of a detection's method, with all other settings unchanged.
[[nodiscard]] inline ThresholdMap thresholdMapOf(const Detection& detection) {
    return rowOf(detection.settings.method).decision.thresholds(detection);
}

} // namespace edgescan::edges
