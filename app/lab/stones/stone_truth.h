// The true edges of a scan of meshes (docs/method/edges.md, "Truth and score").
#pragma once

#include "app/lab/sim/truth/truth_files.h"
#include "app/lab/stones/cell_gaps.h"

namespace edgescan::lab {

/// Jumps, contacts and the rim of the open from rays between the cells; creases from normals smoothed over a few cells. Not scored: smaller
/// jumps, steep surfaces, flat contacts, weaker creases, stones of fewer than 25 cells, absorbing patches. @param simulation with truth, of
/// this scene with these settings @param finer 2 if the steps are half of the usual ones (smooth_normals.h)
[[nodiscard]] sim::TruthSet stoneTruth(const sim::Scene& scene, const sim::Simulation& simulation, const sim::SimulationSettings& settings,
                                       int finer = 1);

} // namespace edgescan::lab
