// The values on the card of a picked cell (docs/guide/measure.md).
#pragma once

#include "core/edges/explain/cell_values.h"
#include "core/edges/pipeline/detection.h"
#include "core/inspect/measure/boom_at.h"
#include "core/inspect/measure/surface_at.h"

#include <cstddef>
#include <optional>

namespace edgescan::inspect {

/// The number after ± is two standard deviations: 95 of 100 readings are within it.
inline constexpr double kReportedSigmas = 2.0;

struct CellTarget {
    edges::Probe probe;
    double distanceM = 0.0;               ///< m, from the scanner along the beam; meaningless if the cell is not valid
    double toleranceM = 0.0;              ///< m, of the distance: two standard deviations of this scan's noise; 0: unknown
    std::optional<Resolution> resolution; ///< empty if the cell is not valid
    std::optional<SurfaceAtCell> surface; ///< empty if a plane does not fit
    std::optional<Dip> dip;               ///< of the surface, relative to the horizon of the mine; empty without a placement
    std::optional<BoomAtCell> boom;       ///< empty if the placement has no boom
    /// Of the edge, 1 = at the threshold; of a cell that is not an edge as Why reports it. Empty if the method does not measure the
    /// surface.
    std::optional<double> strength;
};

/// The noise of the scan: from the detection, or measured now, which costs about as much as opening the scan.
[[nodiscard]] RangeNoise noiseOf(const edges::Detection& detection);

/// `k` must be a cell of the detection's scan; `noise`: noiseOf() the detection.
[[nodiscard]] CellTarget targetAt(const edges::Detection& detection, const RangeNoise& noise, std::size_t k);

} // namespace edgescan::inspect
