// The settings of a simulation as JSON: scene.json of the ground truth.
#pragma once

#include "app/lab/sim/simulate.h"

#include <nlohmann/json_fwd.hpp>

namespace edgescan::sim {

/// Every setting, including the seed, and derived values of scenes with known dimensions: centres of the holes of a wall, treads of a
/// staircase, number of points of a surface.
[[nodiscard]] nlohmann::ordered_json settingsJson(const SimulationSettings& settings);

} // namespace edgescan::sim
