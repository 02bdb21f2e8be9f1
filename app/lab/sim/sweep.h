// One sweep of the scanner over any scene.
#pragma once

#include "app/lab/sim/scene.h"
#include "app/lab/sim/simulate.h"

namespace edgescan::sim {

/// Casts every beam into the scene. `nominal` has settings.lines lines and settings.beams beams. Of the settings, those of the measurement,
/// the patches, the roughness and the seed count, not those that choose a scene. Scan::name is left to the caller. In a scene with copies
/// of meshes the truth has no seams. Error: "cancelled".
[[nodiscard]] Result<Simulation> sweepScene(const Scene& scene, const PolarGeometry& nominal, const SimulationSettings& settings,
                                            const SimulationProgress& progress = {});

/// The true angles of the even or of the odd beams.
[[nodiscard]] PolarGeometry trueAngles(const SimulationSettings& settings, const PolarGeometry& nominal, bool oddBeams);

/// All threads of the settings take lines one by one. Returns false if cancelled.
bool forAllLines(const SimulationSettings& settings, const SimulationProgress& progress, const std::function<void(int line)>& work);

} // namespace edgescan::sim
