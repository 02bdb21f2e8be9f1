// The places where stones come to rest: a rough bell, a draw point, a floor.
#pragma once

#include "app/lab/sim/random.h"
#include "app/lab/sim/stored_mesh.h"
#include "core/base/result.h"

#include <Eigen/Core>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace edgescan::lab {

/// Points of a lattice and its triangles.
struct Sheet {
    std::vector<Eigen::Vector3f> points;
    std::vector<sim::StoredMesh::Corners> triangles;
};

/// A wall or a floor.
struct SiteWall {
    Sheet fine;               ///< what the beams hit; empty if the wall is not scanned
    Sheet coarse;             ///< what stones hit: every fifth row and column
    std::uint16_t number = 1; ///< walls that are parts of one surface have the same
};

/// Sizes of stones are log-normal, metres.
struct StoneSizes {
    int count = 300;
    double medianM = 0.4, sigma = 0.5, leastM = 0.1, mostM = 2.0;
};

/// Metres, the scanner at the origin, z up.
struct Site {
    std::vector<SiteWall> walls;
    StoneSizes sizes;
    /// Where a stone of a size is let go.
    std::function<Eigen::Vector3d(double sizeM, sim::RandomSequence& dice)> start;
    /// Whether a stone at this place is scanned: it is neither at the scanner nor dropped out.
    std::function<bool(const Eigen::Vector3d& placeM)> isScanned;
    double firstLineDeg = 0; ///< of the sweep, before the tilt of the mount
    double mountDeg = 0;     ///< tilt of the scanner about the 0/180 degree line
};

/// "bench": a close look at a heap on a floor, from above. "hangup": a cluster held in a rough bell, seen from below. "pile": muck at a
/// draw point, seen from the side.
[[nodiscard]] const std::vector<std::string>& siteKinds();

/// Error: unknown kind.
Result<Site> siteOf(const std::string& kind, std::uint64_t seed);

} // namespace edgescan::lab
