// The scenes that can be simulated, one function each.
#pragma once

#include "core/sim/scene.h"
#include "core/sim/simulate.h"

namespace edgescan::sim {

struct Rocks {
    int count = 420;
    double size = 1.0;     ///< times the usual sizes
    double rounding = 0.0; ///< as in addRock
};

/// Rocks jammed wall to wall across the bell, seen from below; a chimney through them, the drift to one side (docs/method.md, "Simulator").
/// A fifth more rocks than in the arch lie on the muck. `afterBlast`: at the keystone nearest the middle the arch is broken out, part of
/// that lies on the muck, and rocks round the hole slid down; all others are where they were, and each rock keeps its number and shape.
[[nodiscard]] Scene hangupScene(std::uint64_t seed, const Rocks& rocks, bool afterBlast = false);

/// A muck slope of rocks against one wall, the scanner leaned towards it, the bell open above.
[[nodiscard]] Scene pileScene(std::uint64_t seed, const Rocks& rocks);

/// The bell after the blast: walls, drift, muck, a raise at the top.
[[nodiscard]] Scene emptyScene(std::uint64_t seed);

/// A wall at right angles to the middle beam, three times as wide to each side as it is far, with open holes in it.
struct WallShape {
    double distanceM = 6.0;
    WallHole hole = WallHole::None;
    int holes = 1;      ///< one is in the middle, several are spread over the middle of the wall as the seed says
    double holeM = 2.0; ///< diameter or side
};

/// Centres of the holes in the plane of the wall, metres. Error: there is no room for them.
[[nodiscard]] Result<std::vector<Eigen::Vector2d>> wallHoles(const WallShape& wall, std::uint64_t seed);
[[nodiscard]] Result<Scene> wallScene(const WallShape& wall, std::uint64_t seed);

/// A flat piece at right angles to the middle beam.
struct StaircaseTread {
    double fromXM = 0, toXM = 0;
    double frontM = 0; ///< distance from the scanner's plane
    double stepMm = 0; ///< how far it lies behind the tread towards the middle
};

/// The middle one, nearest, then those towards +x, then those towards -x, kStaircaseMm falling away to both sides.
[[nodiscard]] std::vector<StaircaseTread> staircaseTreads(double distanceM);
[[nodiscard]] Scene staircaseScene(double distanceM);

/// A measured surface, seen from the side of its greatest z: the points as a relief, its highest one at the distance.
/// @param points metres, two at least that differ in x and in y
[[nodiscard]] Scene rescanScene(const std::vector<Eigen::Vector3f>& points, double distanceM);

} // namespace edgescan::sim
