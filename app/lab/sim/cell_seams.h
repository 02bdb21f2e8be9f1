// Finds the seams between neighbouring cells of a sweep.
#pragma once

#include "app/lab/sim/caster.h"
#include "app/lab/sim/simulate.h"
#include "core/scan/grid/cartesian.h"

namespace edgescan::sim {

struct SeamSources {
    const Scene& scene;
    const RayCaster& caster;                   ///< of the scene
    std::array<const CartesianTables*, 2> aim; ///< true directions of even and odd beams
    bool measured = false;                     ///< the mesh consists of measured points, so its facets do not count as folds
};

/// Fills toNextBeam and toNextLine of a line. The other grids of `truth` must be filled, including those of the next line.
void findSeams(const SeamSources& sources, int line, SimulationTruth& truth);

} // namespace edgescan::sim
