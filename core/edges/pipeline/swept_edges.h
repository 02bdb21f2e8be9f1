// The edges of a threshold map at one threshold after another.
#pragma once

#include "core/edges/pipeline/threshold_map.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace edgescan::edges {

/// edgesAt() for many thresholds in a row, as when the user drags a slider: the cost is that of writing the edges, and cells are compared
/// only if many of them can be edges.
class SweptEdges {
public:
    explicit SweptEdges(ThresholdMap map);
    /// edgesAt() of the map, for thresholds from 0.
    [[nodiscard]] Grid<std::uint8_t> at(double threshold) const;

private:
    ThresholdMap map_; // without cells if they are sorted
    int lines_, beams_;
    std::vector<double> values_;       // values of the map, ascending, each once
    std::vector<std::size_t> counts_;  // per value: number of cells with this value or a higher one
    std::vector<std::uint32_t> cells_; // cells with the highest value first
};

} // namespace edgescan::edges
