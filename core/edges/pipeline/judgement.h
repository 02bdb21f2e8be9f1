// What a method measured at one cell, and the thresholds that it compares it with.
#pragma once

#include "core/base/grid.h"
#include "core/edges/edgescan_plus/cell_probe.h"
#include "core/edges/settings/settings.h"

#include <optional>

namespace edgescan {

struct Judgement {
    bool takesPart = true;              ///< false: no range, or masked: no edge whatever the thresholds
    std::optional<double> alongBeams;   ///< gradient, in units of the thresholds; where the method has one
    std::optional<double> alongLines;   ///< likewise
    std::optional<double> directionDeg; ///< of the gradient: 0 along increasing beams, 90 along increasing lines
    double strength = 0.0;              ///< before suppression: gradient, response of the detector, or of jump or fold over its limit
    double lower = 0.0;                 ///< thresholds; equal where there is only one
    double upper = 0.0;
    std::optional<CellStrength> suppressedBy; ///< the neighbour across the edge that is stronger
    std::optional<DepthProbe> depth;          ///< what was measured; EdgeScan+ and its parts only
    bool roundGap = false;                    ///< the response is that of a cell without a range beside it
    DepthEdge kind = DepthEdge::None;         ///< class of the strongest response that counts, edge or not
    Grid<float> linked;                       ///< lines x beams: suppressed strengths, linked by the thresholds; empty: only one threshold
    double (*shown)(double, const Settings&) = nullptr; ///< strengths and thresholds in the unit of the settings; null: they are
};

} // namespace edgescan
