// What the sampling of a scan can tell at a cell.
#pragma once

#include "core/scan/grid/beam_width.h"
#include "core/scan/grid/cartesian.h"

#include <cstddef>
#include <optional>

namespace edgescan {

struct Resolution {
    double spacingM =
        0.0;            ///< to the next measured direction along the beams or across the lines, whichever is farther, at the cell's range
    double beamM = 0.0; ///< width of the beam there

    /// The smallest thing that is seen reliably (docs/operator.md, "S15").
    [[nodiscard]] double smallestM() const { return spacingM + beamM; }
};

/// Empty where the cell is not valid, or where no neighbour's direction is known. `tables`: of `scan`.
[[nodiscard]] std::optional<Resolution> resolutionAt(const Scan& scan, const CartesianTables& tables, std::size_t k,
                                                     const BeamWidth& beam = {});

} // namespace edgescan
