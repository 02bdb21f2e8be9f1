// The shapes of the bell, the drift and the muck.
#include "app/lab/sim/bell.h"

#include "app/lab/sim/noise.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace edgescan::sim {
namespace {

constexpr std::uint16_t kBellFace = 1;
constexpr std::uint16_t kDriftFace = 2;
constexpr std::uint16_t kRoofFace = 3;
constexpr std::uint16_t kMuckFace = 4;
constexpr std::uint16_t kFloorFace = 5;
constexpr std::uint16_t kDriftEndFace = 6;

Surface wallFace(std::uint16_t face) { return {.face = face}; }

void addRoof(Scene& scene, Mesh& mesh, const Bell& bell, const Roof& roof) {
    const int rings = 24 * bell.kind().nodesPerNode;
    const std::vector<Eigen::Vector2d> around = compass(120 * bell.kind().nodesPerNode);
    const auto place = [&](int ring, int column) {
        const Eigen::Vector2d& d = around[static_cast<std::size_t>(column)];
        const double t = static_cast<double>(ring) / (rings - 1);
        const Eigen::Vector3d rim = bell.wall(d.x(), d.y(), bell.kind().topM);
        const double ragged = 1.0 + 0.35 * valueNoise({2.0 * d.x(), 2.0 * d.y(), 5.0}, 77);
        const Eigen::Vector2d inner = roof.openingM + roof.openingRadiusM * ragged * d;
        Eigen::Vector3d p = rim;
        p.head<2>() += (inner - rim.head<2>()) * t;
        p.z() += 2.2 * t * (2.0 - t) + t * 0.7 * valueNoise({0.5 * p.x(), 0.5 * p.y(), 9.0}, 78);
        if (ring > 0 && bell.kind().outwardM != nullptr) p.z() += bell.kind().outwardM(p, 79);
        return p;
    };
    addLattice(scene, mesh, {rings, static_cast<int>(around.size()), true, place}, wallFace(kRoofFace));
}

/// Section of the drift from floor corner to floor corner over the crown: straight sides, round top.
std::vector<Eigen::Vector2d> driftSection() {
    constexpr double kHalfWidth = 2.3;
    constexpr double kSpringing = 0.9;
    constexpr double kRise = 1.5;
    std::vector<Eigen::Vector2d> section;
    for (int i = 0; i < 8; ++i) section.emplace_back(kHalfWidth, kFloorM + (kSpringing - kFloorM) * i / 8.0);
    const std::vector<Eigen::Vector2d> around = compass(64);
    for (std::size_t i = 0; i <= 32; ++i) section.emplace_back(kHalfWidth * around[i].x(), kSpringing + kRise * around[i].y());
    for (int i = 7; i >= 0; --i) section.emplace_back(-kHalfWidth, kFloorM + (kSpringing - kFloorM) * i / 8.0);
    return section;
}

void addDrift(Scene& scene) {
    constexpr double kNear = -1.6; // behind the scanner, inside the bell
    constexpr double kFar = 21.0;
    constexpr int kRows = 76;
    const std::vector<Eigen::Vector2d> section = driftSection();
    const int columns = static_cast<int>(section.size());
    const auto along = [&](int row) { return kNear + (kFar - kNear) * row / (kRows - 1); };
    Mesh mesh;
    const auto side = [&](int row, int column) {
        const Eigen::Vector2d& s = section[static_cast<std::size_t>(column)];
        const double y = along(row);
        const double bulge = 1.0 + 0.05 * valueNoise({0.8 * s.x(), 0.6 * y, 0.8 * s.y()}, 31);
        return Eigen::Vector3d(s.x() * bulge, y, s.y() > 0.5 ? s.y() * bulge : s.y());
    };
    addLattice(scene, mesh, {kRows, columns, false, side}, wallFace(kDriftFace));
    const auto floor = [&](int row, int column) {
        const Eigen::Vector3d left = side(row, 0);
        const Eigen::Vector3d right = side(row, columns - 1);
        return Eigen::Vector3d(left + (right - left) * column / 8.0);
    };
    addLattice(scene, mesh, {kRows, 9, false, floor}, wallFace(kFloorFace));
    for (const int end : {0, kRows - 1}) {
        const Eigen::Vector3d middle(0.0, along(end), 0.0);
        const auto cap = [&](int ring, int column) { return Eigen::Vector3d(middle + (side(end, column) - middle) * ring / 6.0); };
        addLattice(scene, mesh, {7, columns, true, cap}, wallFace(kDriftEndFace));
    }
    scene.voids.push_back(std::move(mesh));
}

} // namespace

std::vector<Eigen::Vector2d> compass(int count) {
    const double step = 2.0 * std::numbers::pi / count;
    const double c = std::cos(step);
    const double s = std::sin(step);
    std::vector<Eigen::Vector2d> units{{1.0, 0.0}};
    for (int i = 1; i < count; ++i) {
        const Eigen::Vector2d last = units.back();
        units.push_back(Eigen::Vector2d(c * last.x() - s * last.y(), s * last.x() + c * last.y()).normalized());
    }
    return units;
}

Eigen::Vector2d Bell::halfAxes(double heightM) const { return kind_->halfAxesM(std::max(0.0, heightM - kFloorM)); }

Eigen::Vector3d Bell::wall(double c, double s, double heightM) const {
    const Eigen::Vector2d axes = halfAxes(heightM);
    // Blasted walls are not elliptic: they have wide bulges and, smaller, half-metre steps between rounds of holes.
    const Eigen::Vector3d place(2.2 * c, 2.2 * s, 0.5 * heightM);
    const double bulge = 1.0 + 0.10 * valueNoise(place, seed_) + 0.035 * valueNoise((2.3 * place).array() + 0.37, seed_ + 1) +
                         0.018 * valueNoise((6.1 * place).array() + 0.71, seed_ + 2);
    Eigen::Vector3d point(axes.x() * c * bulge, axes.y() * s * bulge, heightM);
    if (kind_->outwardM != nullptr) point.head<2>() += kind_->outwardM(point, seed_ + 3) * point.head<2>().normalized();
    return point;
}

double Bell::onGround(double x, double y, double heightM) const {
    return kind_->groundM == nullptr ? heightM : heightM + kind_->groundM({x, y, 0.0}, seed_ + 3);
}

double Bell::share(const Eigen::Vector3d& placeM) const {
    const Eigen::Vector2d axes = halfAxes(placeM.z());
    const Eigen::Vector2d scaled(placeM.x() / axes.x(), placeM.y() / axes.y());
    const double radius = scaled.norm();
    if (radius < 1e-9) return 0.0;
    const Eigen::Vector3d on = wall(scaled.x() / radius, scaled.y() / radius, placeM.z());
    return placeM.head<2>().norm() / on.head<2>().norm();
}

void addBell(Scene& scene, const Bell& bell, const Roof& roof) {
    const WallKind& kind = bell.kind();
    const int rows = 160 * kind.nodesPerNode;
    const std::vector<Eigen::Vector2d> around = compass(288 * kind.nodesPerNode);
    Mesh mesh;
    const auto place = [&](int row, int column) {
        const Eigen::Vector2d& d = around[static_cast<std::size_t>(column)];
        return bell.wall(d.x(), d.y(), kFloorM + (kind.topM - kFloorM) * row / (rows - 1));
    };
    addLattice(scene, mesh, {rows, static_cast<int>(around.size()), true, place}, wallFace(kBellFace));
    const auto floor = [&](int ring, int column) {
        Eigen::Vector3d p = place(0, column);
        p.head<2>() *= ring / 8.0;
        return p;
    };
    addLattice(scene, mesh, {9, static_cast<int>(around.size()), true, floor}, wallFace(kFloorFace));
    if (roof.present) addRoof(scene, mesh, bell, roof);
    scene.voids.push_back(std::move(mesh));
    addDrift(scene);
    if (kind.attach != nullptr) kind.attach(scene, bell);
}

double muckHeight(const Bell& bell, double x, double y, std::uint64_t seed) {
    const double radius = std::sqrt(x * x + y * y);
    const double towardDrift = radius > 1e-9 ? y / radius : 0.0;
    const double foot = 1.1 + 0.9 * valueNoise({x / (radius + 1e-9) * 1.5, towardDrift * 1.5, 3.0}, seed);
    const double open = std::clamp(1.6 * (towardDrift - 0.35), 0.0, 1.0); // the robot drove in here
    const double reach = bell.share({x, y, 0.0}) * 3.0;
    const double rise = 0.95 * std::max(0.0, reach - foot) * (1.0 - open);
    return kFloorM + 0.15 + rise + 0.12 * valueNoise({1.2 * x, 1.2 * y, 1.0}, seed + 1);
}

void addMuck(Scene& scene, const Bell& bell, std::uint64_t seed) {
    addGround(scene, bell, [&](double x, double y) { return muckHeight(bell, x, y, seed); });
}

void addGround(Scene& scene, const Bell& bell, const std::function<double(double x, double y)>& heightM) {
    const int rings = 80 * bell.kind().nodesPerNode;
    const std::vector<Eigen::Vector2d> around = compass(180 * bell.kind().nodesPerNode);
    const auto place = [&](int ring, int column) {
        const Eigen::Vector2d d = around[static_cast<std::size_t>(column)] * (0.3 + 7.7 * ring / (rings - 1));
        return Eigen::Vector3d(d.x(), d.y(), bell.onGround(d.x(), d.y(), heightM(d.x(), d.y())));
    };
    addLattice(scene, scene.solids, {rings, static_cast<int>(around.size()), true, place}, wallFace(kMuckFace));
}

} // namespace edgescan::sim
