// A method's measurements at one cell, and the thresholds that it compares them with.
#pragma once

#include "core/base/grid.h"
#include "core/edges/edgescan_plus/cell_probe.h"
#include "core/edges/settings/settings.h"

#include <cstddef>
#include <functional>
#include <optional>

namespace edgescan::edges {

struct Judgement {
    bool takesPart = true;              ///< false: no range, or masked: not an edge at any threshold
    std::optional<double> alongBeams;   ///< gradient in units of the thresholds, if the method has one
    std::optional<double> alongLines;   ///< the same
    std::optional<double> directionDeg; ///< of the gradient: 0 along increasing beams, 90 along increasing lines
    /// before suppression: gradient, response of the detector, or the larger of jump and fold divided by their limits
    double strength = 0.0;
    double lower = 0.0; ///< thresholds; equal if there is only one
    double upper = 0.0;
    std::optional<CellStrength> suppressedBy; ///< the stronger neighbour across the edge, with its strength in the direction of this cell
    double compared = 0.0; ///< the cell's own strength in that direction, if there is such a neighbour: less than `strength` for many folds
    std::optional<DepthProbe> depth; ///< measurements of EdgeScan+ and its parts only
    /// on a rough scan: the share of the cells within 15 degrees that fold, and how many times as strong a fold must be here
    struct RoughAround {
        double share = 0.0;
        double factor = 1.0;
    };
    std::optional<RoughAround> rough;
    bool movedFromGap = false;                ///< the response was moved here from a cell without a range next to it
    DepthEdge kind = DepthEdge::None;         ///< class of the strongest response among the requested classes, edge or not
    std::function<float(std::size_t)> linked; ///< suppressed strength of a cell, linked by the thresholds; empty if there is only one
    /// converts strengths and thresholds to the unit of the settings; null: they already have it
    double (*shown)(double, const Settings&) = nullptr;
};

} // namespace edgescan::edges
