// The two ends of a sweep's axis: small cones that a fan of more than 180 degrees sees twice in a full turn (docs/calibration.md, "Sweep
// mounting").
#pragma once

#include "core/inspect/calibration/residuals.h"

#include <array>
#include <vector>

namespace edgescan {

/// How far the fan reaches beyond the axis, degrees: at the end of beam 0, and of beam 180. Negative: it does not.
[[nodiscard]] std::array<double, 2> beyondAxisDeg(const PolarGeometry& polar);

/// Beams that look at what both halves of a full turn see, ascending by index: of a spin mounting all.
[[nodiscard]] std::vector<int> beamsSeenTwice(const PolarGeometry& polar);

/// Cells of one half turn within the cones, measured and not alone; up to `most` of them, drawn evenly over the solid angle. A scan draws
/// the same cells each time.
[[nodiscard]] std::vector<SeenCell> cellsAtEnds(const PolarGeometry& polar, const InverseRange& inverse, View view, std::size_t most);

struct EndScale {
    int neighbours = 60; ///< cells of a fit
    int every = 1;       ///< of so many cells one is compared
};

/// Each cell of `cells` against the plane in inverse depth, 1 / |x|, over the nearest cells of `surface`, as seen along the axis.
/// Left out: where these lie to one side, or do not fit to 30 mm + 2 % of the range. `Residual::shares` is the place on the surface.
[[nodiscard]] std::vector<Residual> residualsAtEnds(const TurnedSweep& sweep, const std::vector<SeenCell>& cells,
                                                    const std::vector<SeenCell>& surface, const AssemblyErrors& errors,
                                                    const EndScale& scale);

} // namespace edgescan
