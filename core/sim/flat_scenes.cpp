// Scenes of known measures: a wall, a staircase.
#include "core/sim/bell.h"
#include "core/sim/convex_rock.h"
#include "core/sim/scenes.h"

#include <algorithm>
#include <cmath>

namespace edgescan::sim {
namespace {

constexpr double kReach = 3.0; // half-width of the flat scenes as a multiple of their distance

/// Point of the square with half-side 1 in that direction.
Eigen::Vector2d onSquare(const Eigen::Vector2d& unit) { return unit / unit.cwiseAbs().maxCoeff(); }

} // namespace

Scene wallScene(double distanceM, WallHole hole, double holeM) {
    constexpr int kRings = 3;
    const std::vector<Eigen::Vector2d> around = compass(128); // a multiple of 8: corners of the square are met exactly
    const auto place = [&](int ring, int column) {
        const Eigen::Vector2d& unit = around[static_cast<std::size_t>(column)];
        const Eigen::Vector2d rim = hole == WallHole::Round ? unit : onSquare(unit);
        const Eigen::Vector2d inner = hole == WallHole::None ? Eigen::Vector2d::Zero().eval() : Eigen::Vector2d(0.5 * holeM * rim);
        const Eigen::Vector2d p = inner + (kReach * distanceM * onSquare(unit) - inner) * (static_cast<double>(ring) / (kRings - 1));
        return Eigen::Vector3d(p.x(), p.y(), distanceM);
    };
    Scene scene;
    addLattice(scene, scene.solids, {kRings, static_cast<int>(around.size()), true, place}, {.texture = Texture::Smooth});
    return scene;
}

Scene staircaseScene(double distanceM) {
    const double tread = 0.3 * distanceM;
    const double reach = kReach * distanceM;
    Scene scene;
    std::uint16_t object = kFirstRock;
    const auto add = [&](double x0, double x1, double front) {
        addBox(scene, {Eigen::Vector3d(std::min(x0, x1), -reach, front), Eigen::Vector3d(std::max(x0, x1), reach, front + distanceM)},
               object++);
    };
    add(-0.5 * tread, 0.5 * tread, distanceM);
    for (const double side : {1.0, -1.0}) {
        double front = distanceM;
        double x = 0.5 * tread;
        for (std::size_t i = side > 0.0 ? 0 : 1; i < kStaircaseMm.size(); i += 2) {
            front += 0.001 * kStaircaseMm[i];
            add(side * x, side * (x + tread), front);
            x += tread;
        }
    }
    return scene;
}

} // namespace edgescan::sim
