// The resolution of a scan's sampling at a cell.
#pragma once

#include "core/scan/grid/beam_width.h"
#include "core/scan/grid/cartesian.h"

#include <cstddef>
#include <optional>

namespace edgescan::inspect {

struct Resolution {
    /// m, at the cell's range: distance to the next measured direction along the beams or across the lines, whichever is larger
    double spacingM = 0.0;
    double beamM = 0.0; ///< m: width of the beam there

    /// The smallest object that is detected reliably (docs/reference/rules.md, "S15").
    [[nodiscard]] double smallestM() const { return spacingM + beamM; }
};

/// Empty if the cell is not valid, or if the directions of all neighbours are unknown. `tables`: of `scan`.
[[nodiscard]] std::optional<Resolution> resolutionAt(const Scan& scan, const CartesianTables& tables, std::size_t k,
                                                     const BeamWidth& beam = {});

/// Standard deviation of the range of a cell at the end of its surface, m: a part of the beam misses a slanted surface, and the range is of
/// the rest. A quarter of the beam times the slope away from the end; 0 where the surface goes on at all four sides. `resolution`: of `k`.
[[nodiscard]] double clippedBeamM(const Scan& scan, const CartesianTables& tables, std::size_t k, const Resolution& resolution);

} // namespace edgescan::inspect
