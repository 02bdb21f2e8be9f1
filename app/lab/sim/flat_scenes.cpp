// Scenes with known dimensions: a wall, a staircase.
#include "app/lab/sim/bell.h"
#include "app/lab/sim/convex_rock.h"
#include "app/lab/sim/random.h"
#include "app/lab/sim/scenes.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace edgescan::sim {
namespace {

constexpr double kReach = 3.0;     // half-width of the flat scenes as a multiple of their distance
constexpr double kHoleField = 1.5; // side of the square over which several holes are distributed
constexpr double kHoleSpace = 1.2; // least side of a hole's own square as a multiple of the hole

/// The point, in that direction, of the square with half-side 1.
Eigen::Vector2d onSquare(const Eigen::Vector2d& unit) { return unit / unit.cwiseAbs().maxCoeff(); }

/// Adds the part of the wall between two closed curves, both given by direction.
template <class Inner, class Outer>
void addRing(Scene& scene, double distanceM, Inner inner, Outer outer) {
    constexpr int kRings = 3;
    const std::vector<Eigen::Vector2d> around = compass(128); // a multiple of 8, so that corners of the square are exact
    const auto place = [&](int ring, int column) {
        const Eigen::Vector2d& unit = around[static_cast<std::size_t>(column)];
        const Eigen::Vector2d from = inner(unit);
        const Eigen::Vector2d p = from + (outer(unit) - from) * (static_cast<double>(ring) / (kRings - 1));
        return Eigen::Vector3d(p.x(), p.y(), distanceM);
    };
    addLattice(scene, scene.solids, {kRings, static_cast<int>(around.size()), true, place}, {.texture = Texture::Wall});
}

int squaresPerSide(int holes) {
    int side = 1;
    while (side * side < holes) ++side;
    return side;
}

} // namespace

Result<std::vector<Eigen::Vector2d>> wallHoles(const WallShape& wall, std::uint64_t seed) {
    std::vector<Eigen::Vector2d> centres;
    if (wall.hole == WallHole::None || wall.holes == 0) return centres;
    if (wall.holes == 1) {
        if (wall.holeM >= 2.0 * kReach * wall.distanceM)
            return Error{"the wall is smaller than its hole", "simulate", "use a smaller hole, or a wall farther away"};
        return std::vector<Eigen::Vector2d>{Eigen::Vector2d::Zero()};
    }
    const int side = squaresPerSide(wall.holes);
    const double square = 2.0 * kHoleField * wall.distanceM / side;
    if (kHoleSpace * wall.holeM > square)
        return Error{"the wall has no room for so many holes of this size", "simulate",
                     "use fewer or smaller holes, or a wall farther away"};
    RandomSequence dice(seed, Purpose::Holes);
    std::vector<int> squares(static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
    std::iota(squares.begin(), squares.end(), 0);
    for (int n = 0; n < wall.holes; ++n)
        std::swap(squares[static_cast<std::size_t>(n)],
                  squares[static_cast<std::size_t>(dice.whole(n, static_cast<int>(squares.size()) - 1))]);
    const double play = 0.5 * (square / kHoleSpace - wall.holeM);
    for (int n = 0; n < wall.holes; ++n) {
        const int at = squares[static_cast<std::size_t>(n)];
        const Eigen::Vector2d middle((at % side - 0.5 * (side - 1)) * square, (at / side - 0.5 * (side - 1)) * square);
        const double x = dice.uniform(-play, play);
        centres.emplace_back(middle + Eigen::Vector2d(x, dice.uniform(-play, play)));
    }
    return centres;
}

Result<Scene> wallScene(const WallShape& wall, std::uint64_t seed) {
    const Result<std::vector<Eigen::Vector2d>> holes = wallHoles(wall, seed);
    if (!holes) return holes.error();
    const double reach = kReach * wall.distanceM;
    const int side = squaresPerSide(static_cast<int>(holes->size()));
    // With at most one hole the wall is one square. With several, each hole has its own square, and a frame surrounds all of them.
    const double half = holes->size() < 2 ? reach : kHoleField * wall.distanceM;
    const double square = 2.0 * half / side;
    Scene scene;
    for (int at = 0; at < side * side; ++at) {
        const Eigen::Vector2d middle((at % side - 0.5 * (side - 1)) * square, (at / side - 0.5 * (side - 1)) * square);
        const auto own =
            std::ranges::find_if(*holes, [&](const Eigen::Vector2d& hole) { return (hole - middle).cwiseAbs().maxCoeff() < 0.5 * square; });
        const auto inner = [&](const Eigen::Vector2d& unit) -> Eigen::Vector2d {
            if (own == holes->end()) return middle;
            return *own + 0.5 * wall.holeM * (wall.hole == WallHole::Round ? unit : onSquare(unit));
        };
        const auto outer = [&](const Eigen::Vector2d& unit) -> Eigen::Vector2d { return middle + 0.5 * square * onSquare(unit); };
        addRing(scene, wall.distanceM, inner, outer);
    }
    if (half < reach) {
        addRing(
            scene, wall.distanceM, [&](const Eigen::Vector2d& unit) -> Eigen::Vector2d { return half * onSquare(unit); },
            [&](const Eigen::Vector2d& unit) -> Eigen::Vector2d { return reach * onSquare(unit); });
    }
    return scene;
}

std::vector<StaircaseTread> staircaseTreads(double distanceM) {
    const double width = 0.3 * distanceM;
    std::vector<StaircaseTread> treads{{-0.5 * width, 0.5 * width, distanceM, 0.0}};
    for (const double side : {1.0, -1.0}) {
        double front = distanceM;
        double x = 0.5 * width;
        for (std::size_t i = side > 0.0 ? 0 : 1; i < kStaircaseMm.size(); i += 2) {
            front += 0.001 * kStaircaseMm[i];
            treads.push_back({std::min(side * x, side * (x + width)), std::max(side * x, side * (x + width)), front, kStaircaseMm[i]});
            x += width;
        }
    }
    return treads;
}

Scene staircaseScene(double distanceM) {
    const double reach = kReach * distanceM;
    Scene scene;
    std::uint16_t object = kFirstRock;
    for (const StaircaseTread& tread : staircaseTreads(distanceM)) {
        addBox(scene, {Eigen::Vector3d(tread.fromXM, -reach, tread.frontM), Eigen::Vector3d(tread.toXM, reach, tread.frontM + distanceM)},
               object++);
    }
    return scene;
}

} // namespace edgescan::sim
