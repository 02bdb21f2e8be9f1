// Everything that the card of a picked cell says (docs/targets.md).
#pragma once

#include "core/edges/explain/probe.h"
#include "core/edges/pipeline/detection.h"
#include "core/inspect/measure/boom_at.h"
#include "core/inspect/measure/surface_at.h"

#include <cstddef>
#include <optional>

namespace edgescan {

/// What is told with ± is two standard deviations: 95 of 100 readings lie within.
inline constexpr double kToldSigmas = 2.0;

struct CellTarget {
    Probe probe;
    double distanceM = 0.0;               ///< from the scanner along the beam; means nothing where the cell is not valid
    double toleranceM = 0.0;              ///< of it: two standard deviations of the noise of this scan; 0: too little to tell
    std::optional<Resolution> resolution; ///< empty where the cell is not valid
    std::optional<SurfaceAtCell> surface; ///< empty where no plane fits
    std::optional<Dip> dip;               ///< of the surface, to the mine's horizon; empty without a pose
    std::optional<BoomAtCell> boom;       ///< empty where the place tells of no boom
    std::optional<double>
        strength; ///< of the edge, 1 = at the threshold; empty where the method measures none of the surface, or a neighbour outdid it
};

/// Of the scan: what the detection measured, or measured now, which costs about as much as opening it.
[[nodiscard]] RangeNoise noiseOf(const Detection& detection);

/// `k` must be a cell of the detection's scan; `noise`: noiseOf() it.
[[nodiscard]] CellTarget targetAt(const Detection& detection, const RangeNoise& noise, std::size_t k);

} // namespace edgescan
