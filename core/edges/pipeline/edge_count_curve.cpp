// The edge-count curve from a threshold map.
#include "core/edges/pipeline/edge_count_curve.h"

#include <algorithm>

namespace edgescan::edges {
namespace {

constexpr double kStableShare = 0.8;    // share of the edges that must remain at the end of a plateau
constexpr double kSmallestShare = 0.05; // share of the edges at the first threshold
constexpr double kLargestShare = 0.15;  // share of all cells: with more edges the image is full, not stable

} // namespace

EdgeCountCurve edgeCountCurve(const ThresholdMap& map, std::vector<double> thresholds) {
    EdgeCountCurve curve;
    curve.thresholds = std::move(thresholds);
    const std::size_t places = curve.thresholds.size();
    // A cell counts at every threshold up to its highest one: the histogram, summed from its end.
    curve.edges.assign(places, 0);
    for (const double highest : map.highest.cells) {
        const auto above = std::upper_bound(curve.thresholds.begin(), curve.thresholds.end(), highest) - curve.thresholds.begin();
        if (above > 0) ++curve.edges[static_cast<std::size_t>(above) - 1];
    }
    for (std::size_t n = places - 1; n > 0; --n) curve.edges[n - 1] += curve.edges[n];

    curve.stableFrom = curve.stableTo = curve.thresholds.front();
    double best = 1.0;
    const double most = kLargestShare * static_cast<double>(map.highest.size());
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
