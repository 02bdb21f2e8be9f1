// The scenes of the simulator, one function each.
#pragma once

#include "app/lab/sim/scene.h"
#include "app/lab/sim/simulate.h"
#include "app/lab/sim/wall_kinds.h"

namespace edgescan::sim {

struct Rocks {
    int count = 420;
    double size = 1.0;     ///< factor on the usual sizes
    double rounding = 0.0; ///< as in addRock
};

/// Rocks jammed from wall to wall across the bell, seen from below; a chimney through them, the drift on one side (docs/method/edges.md,
/// "Simulator"). On the muck there are a fifth as many rocks as in the arch. `afterBlast`: the arch is broken out at the keystone nearest
/// to the middle, a part of it is on the muck, and rocks around the hole slid down. All other rocks are unmoved, and each rock has the same
/// number and shape as before.
[[nodiscard]] Scene hangupScene(std::uint64_t seed, const Rocks& rocks, const WallKind& wall, bool afterBlast = false);

/// A muck slope of rocks against one wall, the scanner tilted towards it, the bell open above.
[[nodiscard]] Scene pileScene(std::uint64_t seed, const Rocks& rocks, const WallKind& wall);

/// The bell after the blast: walls, drift, muck, a raise at the top.
[[nodiscard]] Scene emptyScene(std::uint64_t seed, const WallKind& wall);

/// A wall at right angles to the middle beam with open holes in it. On each side it extends three times its distance.
struct WallShape {
    double distanceM = 6.0;
    WallHole hole = WallHole::None;
    int holes = 1;      ///< one hole is in the middle, several are distributed over the middle of the wall according to the seed
    double holeM = 2.0; ///< diameter or side, metres
};

/// Centres of the holes in the plane of the wall, metres. Error: the wall is too small for them.
[[nodiscard]] Result<std::vector<Eigen::Vector2d>> wallHoles(const WallShape& wall, std::uint64_t seed);
[[nodiscard]] Result<Scene> wallScene(const WallShape& wall, std::uint64_t seed);

/// A flat piece at right angles to the middle beam.
struct StaircaseTread {
    double fromXM = 0, toXM = 0;
    double frontM = 0; ///< distance from the scanner's plane
    double stepMm = 0; ///< distance behind the neighbouring tread nearer to the middle
};

/// The middle tread, which is the nearest, then those towards +x, then those towards -x. On both sides the steps between them are
/// kStaircaseMm.
[[nodiscard]] std::vector<StaircaseTread> staircaseTreads(double distanceM);
[[nodiscard]] Scene staircaseScene(double distanceM);

/// A measured surface, seen from the side of its largest z: the points as a relief, its highest point at the distance. @param points
/// metres; at least two that differ in x and in y
[[nodiscard]] Scene rescanScene(const std::vector<Eigen::Vector3f>& points, double distanceM);

} // namespace edgescan::sim
