// The edge-count curve and its plateau.
#include "core/edges/pipeline/edge_count_curve.h"

#include "core/edges/pipeline/methods.h"

#include <algorithm>

namespace edgescan::edges {
namespace {

constexpr double kStableShare = 0.8;    // share of the edges that must remain at the end of a plateau
constexpr double kSmallestShare = 0.05; // share of the edges at the first threshold
constexpr double kLargestShare = 0.15;  // share of all cells: with more edges the image is full, not stable

} // namespace

EdgeCountCurve edgeCountCurve(const Detection& detection, std::vector<double> thresholds) {
    const EdgeLevels levels = rowOf(detection.settings.method).decision.levels(detection, thresholds);
    std::vector<std::size_t> edges = edgeCounts(levels, thresholds.size());
    return edgeCountCurve(std::move(edges), std::move(thresholds), levels.weak.size());
}

EdgeCountCurve edgeCountCurve(std::vector<std::size_t> edges, std::vector<double> thresholds, std::size_t cells) {
    EdgeCountCurve curve{std::move(thresholds), std::move(edges)};
    const std::size_t places = curve.thresholds.size();
    curve.stableFrom = curve.stableTo = curve.thresholds.front();
    double best = 1.0;
    const double most = kLargestShare * static_cast<double>(cells);
    const double fewest = kSmallestShare * std::min(most, static_cast<double>(curve.edges.front()));
    std::size_t end = 0;
    for (std::size_t start = 0; start < places; ++start) {
        const auto here = static_cast<double>(curve.edges[start]);
        if (curve.thresholds[start] <= 0 || here > most || here < std::max(fewest, 1.0)) continue;
        end = std::max(end, start);
        while (end + 1 < places && static_cast<double>(curve.edges[end + 1]) >= kStableShare * here) ++end;
        const double ratio = curve.thresholds[end] / curve.thresholds[start];
        if (ratio <= best) continue;
        best = ratio;
        curve.stableFrom = curve.thresholds[start];
        curve.stableTo = curve.thresholds[end];
    }
    return curve;
}

} // namespace edgescan::edges
