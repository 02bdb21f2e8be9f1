// The edge-count curve: how many cells are edges at each threshold.
#pragma once

#include "core/edges/pipeline/detection.h"

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

/// The curve of a detection's method at these thresholds (ascending, two at least, kMostLevels at most), other settings unchanged.
[[nodiscard]] EdgeCountCurve edgeCountCurve(const Detection& detection, std::vector<double> thresholds);

/// The curve of these counts on a scan of `cells`. The plateau is the longest stretch, as the ratio of its ends, over which at
/// most a fifth of the edges disappear. Stretches that begin with more than 15 % of all cells do not count. Stretches with less than 5 % of
/// the edges at the first threshold, or less than 5 % of that many cells, do not count either.
[[nodiscard]] EdgeCountCurve edgeCountCurve(std::vector<std::size_t> edges, std::vector<double> thresholds, std::size_t cells);

} // namespace edgescan::edges
