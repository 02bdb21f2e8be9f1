// The edge-count curve: how many cells are edges at each threshold.
#pragma once

#include "core/edges/pipeline/threshold_map.h"

#include <cstddef>
#include <vector>

namespace edgescan::edges {

/// Number of edge cells at every threshold, and the range of thresholds in which it changes little.
struct EdgeCountCurve {
    std::vector<double> thresholds; ///< ascending
    std::vector<std::size_t> edges; ///< never increasing
    double stableFrom = 0.0;        ///< the plateau; stableTo == stableFrom if there is none
    double stableTo = 0.0;
};

/// The curve at these thresholds (ascending, at least two). The plateau is the longest stretch, as the ratio of its ends, over which at
/// most a fifth of the edges disappear. Stretches that begin with more than 15 % of all cells do not count. Stretches with less than 5 % of
/// the edges at the first threshold, or less than 5 % of that many cells, do not count either.
[[nodiscard]] EdgeCountCurve edgeCountCurve(const ThresholdMap& map, std::vector<double> thresholds);

} // namespace edgescan::edges
