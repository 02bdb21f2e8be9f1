// Folds of measured surfaces (docs/method/edges.md, "Truth and score").
#pragma once

#include "core/sim/simulate.h"

namespace edgescan::sim {

/// The truth of a re-scanned surface with its folds. A mesh of measured points has a fold at every side of a triangle, so the truth of the
/// simulator knows none of them. Here a fold between two cells is the angle between the mean normals of the 100 mm on each side, up to a
/// jump. It counts in full where it is largest across the fold, and as at most 30 degrees, which is not sure, elsewhere.
[[nodiscard]] SimulationTruth withFacetFolds(const Simulation& simulation);

} // namespace edgescan::sim
