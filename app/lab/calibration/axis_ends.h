// The two ends of a sweep's rotation axis: small cones that a fan of more than 180 degrees sees twice in a full turn
// (docs/reference/calibration.md, "Sweep mounting").
#pragma once

#include "app/lab/calibration/residuals.h"

#include <array>
#include <vector>

namespace edgescan::inspect {

/// How far the fan extends beyond the axis, degrees: at the end of beam 0, and at that of beam 180. Negative if it does not reach the axis.
[[nodiscard]] std::array<double, 2> beyondAxisDeg(const PolarGeometry& polar);

/// Indices of the beams that see what both halves of a full turn see, ascending; for a spin mounting all beams.
[[nodiscard]] std::vector<int> beamsSeenTwice(const PolarGeometry& polar);

/// Cells of one half turn within the cones that were measured and are not isolated; up to `most` of them, drawn evenly over the solid
/// angle. The same scan gives the same cells each time.
[[nodiscard]] std::vector<SeenCell> cellsAtEnds(const PolarGeometry& polar, const InverseRange& inverse, View view, std::size_t most);

struct EndScale {
    int neighbours = 60; ///< number of cells in a fit
    int every = 1;       ///< one of this many cells is compared
};

/// Compares each cell of `cells` with the plane in inverse depth, 1 / |x|, through the nearest cells of `surface`, as seen along the axis.
/// Left out: cells whose neighbours are all on one side, or whose misfit exceeds 30 mm + 2 % of the range. `Residual::shares` is the tile
/// of the surface.
[[nodiscard]] std::vector<Residual> residualsAtEnds(const PreparedSweep& sweep, const std::vector<SeenCell>& cells,
                                                    const std::vector<SeenCell>& surface, const AssemblyErrors& errors,
                                                    const EndScale& scale);

} // namespace edgescan::inspect
