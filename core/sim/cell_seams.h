// What lies between neighbouring cells of a sweep.
#pragma once

#include "core/scan/grid/cartesian.h"
#include "core/sim/caster.h"
#include "core/sim/simulate.h"

namespace edgescan::sim {

struct SeamSources {
    const Scene& scene;
    const Caster& caster;                      ///< of the scene
    std::array<const CartesianTables*, 2> aim; ///< where even and odd beams really point
    bool measured = false;                     ///< the mesh was made of measured points, so its facets are no folds
};

/// Fills toNextBeam and toNextLine of a line; the other grids of `truth` must be filled, those of the next line too.
void findSeams(const SeamSources& sources, int line, SimulationTruth& truth);

} // namespace edgescan::sim
