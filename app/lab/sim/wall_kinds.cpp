// One small function per kind of wall, and their table.
#include "app/lab/sim/wall_kinds.h"

#include "app/lab/sim/bell.h"
#include "app/lab/sim/noise.h"
#include "app/lab/sim/random.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

namespace edgescan::sim {
namespace {

Eigen::Vector2d funnel(double h) {
    // Steep at the throat, then flaring, then steep again near the top.
    const double flare = h * h / (h + 2.0);
    const double spread = flare < 6.0 ? flare : 6.0 + (flare - 6.0) * 0.45;
    return {3.1 + 0.62 * spread, 2.9 + 0.50 * spread};
}

Eigen::Vector2d chimney(double h) { return {1.9 + 0.02 * h, 1.7 + 0.02 * h}; }

Eigen::Vector2d tunnel(double h) { return {2.7 - 0.05 * h, 11.0}; }

double rough(const Eigen::Vector3d& place, std::uint64_t seed) { return 0.08 * fractalNoise(place, 0.9, 3, seed); }

double bulging(const Eigen::Vector3d& place, std::uint64_t seed) {
    return 0.35 * valueNoise(place / 1.3, seed) + 0.25 * valueNoise(place / 0.6, seed + 1);
}

// Three sets of joints, nearly at right angles to each other, part the rock into blocks. Each block is in front of or behind the plain
// wall.
double blocky(const Eigen::Vector3d& place, std::uint64_t seed) {
    constexpr double kDepthM = 0.3;
    RandomSequence dice(seed, Purpose::Walls);
    std::uint64_t block = 0;
    for (int set = 0; set < 3; ++set) {
        Eigen::Vector3d normal = Eigen::Vector3d::Unit(set);
        for (int axis = 0; axis < 3; ++axis) normal[axis] += dice.uniform(-0.3, 0.3);
        const double spacingM = dice.uniform(0.5, 1.1);
        const auto layer = static_cast<std::int64_t>(std::floor(normal.normalized().dot(place) / spacingM));
        block = mixed(block ^ static_cast<std::uint64_t>(layer));
    }
    return kDepthM * (uniformOf(mixed(block ^ seed)) - 0.5);
}

// Lips: on the way up the wall comes forward, and behind each lip it steps back.
double brows(const Eigen::Vector3d& place, std::uint64_t seed) {
    constexpr double kHighM = 2.6;
    constexpr double kDeepM = 0.9;
    const Eigen::Vector3d around(0.4 * place.x(), 0.4 * place.y(), 3.0);
    const double turn = place.z() / kHighM + 0.8 * valueNoise(around, seed);
    const double deep = std::max(0.0, 0.6 + 0.8 * valueNoise({around.x(), around.y(), 0.3 * place.z()}, seed + 1));
    return kDeepM * deep * (0.5 - (turn - std::floor(turn)));
}

// Round lumps with sharp valleys between them.
double muck(const Eigen::Vector3d& place, std::uint64_t seed) {
    return 0.45 * std::abs(valueNoise(place / 0.35, seed)) + 0.06 * fractalNoise(place, 0.8, 3, seed + 7);
}

constexpr int kBoltsAround = 24;
constexpr double kBoltRowM = 1.3;

/// 0 at the bolts, 1 in the middle between four of them.
double between(double aroundTurns, double heightM) {
    const double a = aroundTurns * kBoltsAround - std::floor(aroundTurns * kBoltsAround);
    const double b = heightM / kBoltRowM - std::floor(heightM / kBoltRowM);
    return 16.0 * a * (1.0 - a) * b * (1.0 - b);
}

struct WirePlace {
    Eigen::Vector2d direction; ///< from the axis
    double turns = 0.0;        ///< the same, 0 to 1 all round
    double heightM = 0.0;
};

// A wire of the mesh that hangs before the wall, as a strip that faces the axis.
void addWire(Scene& scene, const Bell& bell, int nodes, bool upright, const std::function<WirePlace(int node)>& placeOf) {
    constexpr double kWidthM = 0.008;
    constexpr double kSagM = 0.15;
    constexpr double kOffM = 0.02;
    const auto point = [&](int side, int node) {
        const WirePlace at = placeOf(node);
        Eigen::Vector3d p = bell.wall(at.direction.x(), at.direction.y(), at.heightM);
        const Eigen::Vector2d out = p.head<2>().normalized();
        p.head<2>() -= (kOffM + kSagM * between(at.turns, at.heightM)) * out;
        const double half = (side == 0 ? -0.5 : 0.5) * kWidthM;
        if (upright)
            p.head<2>() += half * Eigen::Vector2d(-out.y(), out.x());
        else
            p.z() += half;
        return p;
    };
    addLattice(scene, scene.solids, {2, nodes, false, point}, {.texture = Texture::Smooth});
}

// Bolts with plates on a lattice, and a mesh of wires, 0.1 m wide, that hangs between them.
void boltsAndMesh(Scene& scene, const Bell& bell) {
    constexpr double kMeshM = 0.1;
    constexpr double kLowM = 2.8; // above the drift
    constexpr double kHighM = 9.0;
    constexpr int kUpright = 280;
    const std::vector<Eigen::Vector2d> around = compass(kUpright);
    const int levels = static_cast<int>((kHighM - kLowM) / kMeshM);
    const auto crossing = [&](int column, int level) {
        return WirePlace{around[static_cast<std::size_t>(column % kUpright)], static_cast<double>(column) / kUpright,
                         kLowM + kMeshM * level};
    };
    for (int level = 0; level < levels; ++level)
        addWire(scene, bell, kUpright + 1, false, [&](int column) { return crossing(column, level); });
    for (int column = 0; column < kUpright; ++column)
        addWire(scene, bell, levels, true, [&](int level) { return crossing(column, level); });
    const std::vector<Eigen::Vector2d> bolts = compass(kBoltsAround);
    const std::vector<Eigen::Vector2d> rim = compass(8);
    for (double height = kLowM; height < kHighM; height += kBoltRowM) {
        for (const Eigen::Vector2d& d : bolts) {
            const Eigen::Vector3d foot = bell.wall(d.x(), d.y(), height);
            const Eigen::Vector3d inward = -Eigen::Vector3d(foot.x(), foot.y(), 0.0).normalized();
            const Eigen::Vector3d side(-inward.y(), inward.x(), 0.0);
            // Radius and height above the wall: the tail of the bolt, the nut, and the plate of 0.2 m.
            constexpr std::array<std::array<double, 2>, 5> kOutline{
                {{0.0, 0.16}, {0.02, 0.16}, {0.025, 0.06}, {0.10, 0.04}, {0.12, -0.05}}};
            const auto place = [&](int ring, int column) {
                const auto& [radius, high] = kOutline[static_cast<std::size_t>(ring)];
                const Eigen::Vector2d& u = rim[static_cast<std::size_t>(column)];
                return Eigen::Vector3d(foot + high * inward + radius * (u.x() * side + u.y() * Eigen::Vector3d::UnitZ()));
            };
            addLattice(scene, scene.solids, {static_cast<int>(kOutline.size()), 8, true, place}, {.texture = Texture::Smooth});
        }
    }
}

constexpr std::array kKinds{
    WallKind{.name = "plain", .help = "wide bulges and half-metre steps", .halfAxesM = funnel},
    WallKind{.name = "rough", .help = "hollows and knobs of 0.2 to 1 m", .halfAxesM = funnel, .nodesPerNode = 2, .outwardM = rough},
    WallKind{.name = "blocky",
             .help = "blocks between joints, in front of or behind each other",
             .halfAxesM = funnel,
             .nodesPerNode = 2,
             .outwardM = blocky},
    WallKind{.name = "bulging", .help = "round bulges of 1 to 3 m", .halfAxesM = funnel, .nodesPerNode = 2, .outwardM = bulging},
    WallKind{.name = "brows", .help = "overhanging lips with steps behind them", .halfAxesM = funnel, .nodesPerNode = 2, .outwardM = brows},
    WallKind{.name = "bolted", .help = "bolts with plates, and a mesh of wires", .halfAxesM = funnel, .attach = boltsAndMesh},
    WallKind{.name = "muck", .help = "loose ground of lumps", .halfAxesM = funnel, .nodesPerNode = 2, .groundM = muck},
    WallKind{.name = "chimney", .help = "a raise of 4 m", .halfAxesM = chimney},
    WallKind{.name = "tunnel",
             .help = "a tunnel with a round roof, without room for an arch",
             .halfAxesM = tunnel,
             .topM = 2.6,
             .archFits = false},
};

} // namespace

std::span<const WallKind> wallKinds() { return kKinds; }

const WallKind* wallKindNamed(std::string_view name) {
    const auto found = std::ranges::find(kKinds, name, [](const WallKind& kind) { return std::string_view(kind.name); });
    return found == kKinds.end() ? nullptr : &*found;
}

} // namespace edgescan::sim
