// The gaps in depth between neighbouring cells, from rays in between.
#pragma once

#include "app/lab/sim/caster.h"
#include "app/lab/sim/simulate.h"
#include "core/scan/grid/scan.h"

namespace edgescan::lab {

/// Between two cells: the differences of range along seven rays between them and the two ends.
struct CellGap {
    float largestM = 0;
    float thirdM = 0;  ///< the third largest difference; near the largest one where a surface is only steep
    bool open = false; ///< one of the rays hits nothing
};

struct CellGaps {
    Grid<CellGap> toNextBeam, toNextLine; ///< the last beam and the last line have none
};

/// @param angles the true ones @param clean range of each cell, mm; 0 without a hit @param settings lines, beams and threads
[[nodiscard]] CellGaps cellGaps(const sim::Scene& scene, const PolarGeometry& angles, const Grid<float>& cleanMm,
                                const sim::SimulationSettings& settings);

} // namespace edgescan::lab
