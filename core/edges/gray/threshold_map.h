// The highest threshold at which each cell is an edge: one map, after which any threshold is a compare (docs/method.md, "Threshold map").
#pragma once

#include "core/base/grid.h"
#include "core/edges/gray/gradient.h"
#include "core/edges/settings/settings.h"
#include "core/scan/grid/scan.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace edgescan {

/// A cell is an edge exactly when threshold <= highest. Never an edge: below 0. Infinite: at every threshold.
struct ThresholdMap {
    Grid<double> highest; ///< lines x beams, in units of the threshold that is swept
};

/// Canny with a fixed ratio upper : lower over Settings::lower: greyscale reconstruction (Vincent 1993) of the suppressed magnitude from
/// its strong cells, 8 neighbours. Identical to cannyOfGradient() at every lower threshold from 0.
[[nodiscard]] ThresholdMap cannyThresholdMap(const Gradient& gradient, const Settings& settings);

/// Log-range Canny over Settings::stepPercent; identical to logRangeEdges() at every step from 0.
[[nodiscard]] ThresholdMap logRangeThresholdMap(const Scan& scan, const Settings& settings);

/// A detector with one threshold: response > threshold.
[[nodiscard]] ThresholdMap responseThresholdMap(const Grid<float>& response);

/// Responses that are linked by hysteresis over its high threshold: a chain is kept where it is above `lowShare` x high throughout, above
/// high somewhere, and `minimumLength` cells long at least (8 neighbours). Strengths and thresholds are compared as float.
[[nodiscard]] ThresholdMap linkedThresholdMap(const Grid<float>& strength, double lowShare, int minimumLength);

/// 255 where the cell is an edge at this threshold.
[[nodiscard]] Grid<std::uint8_t> edgesAt(const ThresholdMap& map, double threshold);

/// The same for one threshold after the other, as under a hand on the slider: the work is that of writing the edges, and no cell is
/// compared where few can be edges at all.
class SweptEdges {
public:
    explicit SweptEdges(ThresholdMap map);
    /// edgesAt() of the map, for thresholds from 0.
    [[nodiscard]] Grid<std::uint8_t> at(double threshold) const;

private:
    ThresholdMap map_; // without cells where they are sorted
    int lines_, beams_;
    std::vector<double> values_;       // of the map, ascending, each once
    std::vector<std::size_t> counts_;  // per value: cells that have it or a higher one
    std::vector<std::uint32_t> cells_; // those with the highest value first
};

/// Number of edge cells at every threshold, and where it hardly changes.
struct EdgeCountCurve {
    std::vector<double> thresholds; ///< ascending
    std::vector<std::size_t> edges; ///< never rising
    double stableFrom = 0.0;        ///< the plateau; stableTo == stableFrom when there is none
    double stableTo = 0.0;
};

/// At these thresholds (ascending, two at least). The plateau is the longest stretch, as ratio of its ends, over which no more than a fifth
/// of the edges goes. Stretches that begin with over 15 % of all cells do not count, nor those that hold under 5 % of the edges at the
/// first threshold, or of that many cells.
[[nodiscard]] EdgeCountCurve edgeCountCurve(const ThresholdMap& map, std::vector<double> thresholds);

/// Largest threshold at which `holds` is true, to the last bit; `holds` must be true for small ones and false for large ones. Below 0: for
/// none from 0; infinity: for all. `guess` should be close.
[[nodiscard]] double largestThreshold(const std::function<bool(double)>& holds, double guess);

/// `marker` spread under `mask` to the 8 neighbours: the largest value that reaches each cell, limited by the mask on its way.
/// marker <= mask in every cell.
[[nodiscard]] Grid<double> reconstructed(Grid<double> marker, const Grid<double>& mask);

} // namespace edgescan
