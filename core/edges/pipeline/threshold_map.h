// The highest threshold at which each cell is an edge. With this map, the edges at any threshold need one comparison per cell
// (docs/method/edges.md, "Threshold map").
#pragma once

#include "core/base/grid.h"
#include "core/edges/gray/gradient.h"
#include "core/edges/settings/settings.h"
#include "core/scan/grid/scan.h"

#include <cstddef>
#include <cstdint>
#include <functional>

namespace edgescan::edges {

/// A cell is an edge exactly if threshold <= highest. Below 0: never an edge. Infinite: at every threshold.
struct ThresholdMap {
    Grid<double> highest; ///< lines x beams, in units of the swept threshold
};

/// For Canny with a fixed ratio upper : lower, swept over Settings::lower: greyscale reconstruction (Vincent 1993) of the suppressed
/// magnitude from its strong cells, 8 neighbours. Identical to cannyOfGradient() at every lower threshold from 0.
[[nodiscard]] ThresholdMap cannyThresholdMap(const Gradient& gradient, const Settings& settings);

/// For log-range Canny, swept over Settings::stepPercent; identical to logRangeEdges() at every step from 0.
[[nodiscard]] ThresholdMap logRangeThresholdMap(const Scan& scan, const Settings& settings);

/// For a detector with one threshold: response > threshold.
[[nodiscard]] ThresholdMap responseThresholdMap(const Grid<float>& response);

/// For responses linked by hysteresis, swept over the high threshold: a chain is an edge if it is above `lowShare` x high throughout, above
/// high somewhere, and at least `minimumLength` cells long (8 neighbours). Strengths and thresholds are compared as float.
[[nodiscard]] ThresholdMap linkedThresholdMap(const Grid<float>& strength, double lowShare, int minimumLength);

/// The value of one cell in these maps. It depends only on the cells that are connected with it, so no map of the scan is made.
/// `strengthOf`: of a cell of a scan of lines x beams.
[[nodiscard]] double cannyThresholdAt(const Gradient& gradient, const Settings& settings, std::size_t k);
[[nodiscard]] double logRangeThresholdAt(const Scan& scan, const Settings& settings, std::size_t k);
[[nodiscard]] double responseThresholdAt(const Grid<float>& response, std::size_t k);
[[nodiscard]] double linkedThresholdAt(int lines, int beams, const std::function<float(std::size_t)>& strengthOf, double lowShare,
                                       int minimumLength, std::size_t k);

/// 255 where the cell is an edge at this threshold.
[[nodiscard]] Grid<std::uint8_t> edgesAt(const ThresholdMap& map, double threshold);

/// The largest threshold at which `holds` is true, to the last bit. `holds` must be true for small thresholds and false for large ones.
/// Below 0: false for all from 0; infinity: true for all. `guess` should be close.
[[nodiscard]] double largestThreshold(const std::function<bool(double)>& holds, double guess);

/// Greyscale reconstruction: `marker` spread under `mask` to the 8 neighbours. The result is the largest value that reaches each cell,
/// limited by the mask on its path. marker <= mask in every cell.
[[nodiscard]] Grid<double> reconstructed(Grid<double> marker, const Grid<double>& mask);

} // namespace edgescan::edges
