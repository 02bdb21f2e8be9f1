// The scenes that can be simulated.
#pragma once

#include "core/sim/scene.h"

#include <cstdint>

namespace edgescan::sim {

/// Rocks jammed wall to wall across the bell, seen from below; a chimney through them, the drift to one side (METHOD.md "Scenes").
/// @param rocks in the arch; about a tenth more lie on the muck
[[nodiscard]] Scene hangupScene(std::uint64_t seed, int rocks);

} // namespace edgescan::sim
