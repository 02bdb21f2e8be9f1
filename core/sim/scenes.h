// The scenes that can be simulated, one function each.
#pragma once

#include "core/sim/scene.h"
#include "core/sim/simulate.h"

namespace edgescan::sim {

/// Rocks jammed wall to wall across the bell, seen from below; a chimney through them, the drift to one side (METHOD.md "Scenes").
/// @param rocks in the arch; a fifth more lie on the muck
/// @param rounding of the rocks, as in addRock
[[nodiscard]] Scene hangupScene(std::uint64_t seed, int rocks, double rounding);

/// A muck slope of rocks against one wall, the scanner leaned towards it, the bell open above.
[[nodiscard]] Scene pileScene(std::uint64_t seed, int rocks, double rounding);

/// The bell after the blast: walls, drift, muck, a raise at the top.
[[nodiscard]] Scene emptyScene(std::uint64_t seed);

/// A flat wall at right angles to the middle beam, three times as wide to each side as it is far, with or without an open hole.
[[nodiscard]] Scene wallScene(double distanceM, WallHole hole, double holeM);

/// Treads at right angles to the middle beam, the middle one nearest, kStaircaseMm falling away to both sides.
[[nodiscard]] Scene staircaseScene(double distanceM);

/// A measured surface, seen from the side of its greatest z: the points as a relief, its highest one at the distance.
/// @param points metres, two at least that differ in x and in y
[[nodiscard]] Scene rescanScene(const std::vector<Eigen::Vector3f>& points, double distanceM);

} // namespace edgescan::sim
