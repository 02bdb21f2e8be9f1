// Builds the walls on which stones come to rest.
#include "app/lab/stones/site.h"

#include "app/lab/sim/noise.h"
#include "core/base/portable_math.h"
#include "core/scan/georef/rotations.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace edgescan::lab {
namespace {

using sim::RandomSequence;
using PointOf = std::function<Eigen::Vector3d(int row, int column)>;

/// Every `step`-th number below `count`, and the last one unless the numbers go round.
std::vector<int> everyOf(int count, int step, bool round) {
    std::vector<int> numbers;
    for (int n = 0; n < count; n += step) numbers.push_back(n);
    if (!round && numbers.back() != count - 1) numbers.push_back(count - 1);
    return numbers;
}

Sheet sheetOf(const std::vector<Eigen::Vector3d>& nodes, int columns, const std::vector<int>& rows, const std::vector<int>& taken,
              bool closed) {
    Sheet sheet;
    for (const int i : rows) {
        for (const int j : taken) sheet.points.push_back(nodes[static_cast<std::size_t>(i * columns + j)].cast<float>());
    }
    const int width = static_cast<int>(taken.size());
    for (int i = 0; i + 1 < static_cast<int>(rows.size()); ++i) {
        for (int j = 0; j < (closed ? width : width - 1); ++j) {
            const int here = i * width + j, next = i * width + (j + 1) % width;
            sheet.triangles.push_back({here, next, here + width});
            sheet.triangles.push_back({next, next + width, here + width});
        }
    }
    return sheet;
}

struct Lattice {
    int rows, columns;
    bool closed = false; ///< the last column joins the first
};

SiteWall wallOf(const Lattice& lattice, std::uint16_t number, const PointOf& point, bool scanned = true) {
    constexpr int kCoarser = 5;
    std::vector<Eigen::Vector3d> nodes;
    for (int i = 0; i < lattice.rows; ++i) {
        for (int j = 0; j < lattice.columns; ++j) nodes.push_back(point(i, j));
    }
    const auto sheet = [&](int step) {
        return sheetOf(nodes, lattice.columns, everyOf(lattice.rows, step, false), everyOf(lattice.columns, step, lattice.closed),
                       lattice.closed);
    };
    return {scanned ? sheet(1) : Sheet{}, sheet(kCoarser), number};
}

/// Standard deviation 1; the wavelength is that of the largest lumps, which hold most of the height.
double reliefOf(const Eigen::Vector3d& placeM, double lumpM, std::uint64_t seed) {
    constexpr double kLatticePerLump = 1.8;
    return sim::fractalNoise(placeM, kLatticePerLump * lumpM, 3, seed);
}

double rockFaceM(const Eigen::Vector3d& placeM, std::uint64_t seed) {
    return 0.030 * reliefOf(placeM, 1.5, seed) + 0.008 * reliefOf(placeM, 0.25, seed + 16);
}

/// A plane from a corner along two sides, with relief across it.
struct Plane {
    Eigen::Vector3d corner, along, up;
    Lattice lattice;
    double roughness; ///< factor on the relief
    std::uint16_t number;
};

SiteWall planeWall(const Plane& plane, std::uint64_t seed) {
    const Eigen::Vector3d normal = plane.along.cross(plane.up).normalized();
    return wallOf(plane.lattice, plane.number, [&](int i, int j) -> Eigen::Vector3d {
        const Eigen::Vector3d flat =
            plane.corner + plane.along * (1.0 * i / (plane.lattice.rows - 1)) + plane.up * (1.0 * j / (plane.lattice.columns - 1));
        return flat + plane.roughness * rockFaceM(flat, seed) * normal;
    });
}

Eigen::Vector2d onCircle(double radius, RandomSequence& dice) {
    const double r = radius * std::sqrt(dice.uniform());
    const double angle = 2 * std::numbers::pi * dice.uniform();
    return {r * portable::cos(angle), r * portable::sin(angle)};
}

/// A funnel with a plug in it, on which the stones settle; the plug is not scanned, so that they hang.
Site hangup(std::uint64_t seed, RandomSequence& dice) {
    constexpr double kThroatM = 2.6, kThroatHeightM = 1.0, kBottomM = -1.6, kTopM = 11.0;
    constexpr int kRows = 420, kPlug = 121;
    const double opening = std::tan(radians(dice.uniform(25, 36)));
    const double arch = dice.uniform(2.0, 3.0), dome = dice.uniform(0.3, 0.9);
    const double slopeTo = dice.uniform(0, 2 * std::numbers::pi), slope = std::tan(dice.uniform(0, 0.25));
    const auto radius = [=](double z) { return kThroatM + std::max(0.0, z - kThroatHeightM) * opening; };
    Site site;
    site.walls.push_back(wallOf({kRows, kRows, true}, 1, [&](int i, int j) -> Eigen::Vector3d {
        const double z = kBottomM + (kTopM - kBottomM) * i / (kRows - 1), angle = 2 * std::numbers::pi * j / kRows;
        const Eigen::Vector3d outward(portable::cos(angle), portable::sin(angle), 0);
        const Eigen::Vector3d smooth = radius(z) * outward + Eigen::Vector3d(0, 0, z);
        return smooth + 2 * rockFaceM(smooth, seed) * outward;
    }));
    const double half = radius(arch + dome) + 1.0, rim = radius(arch);
    const auto plug = [&](int i, int j) -> Eigen::Vector3d {
        const double x = half * (2.0 * i / (kPlug - 1) - 1), y = half * (2.0 * j / (kPlug - 1) - 1);
        const double share = (x * x + y * y) / (rim * rim);
        const double z = arch + dome * (1 - share) + 0.5 * slope * (x * portable::cos(slopeTo) + y * portable::sin(slopeTo));
        return {x, y, z + 0.16 * reliefOf({x, y, 0}, 1.1, seed + 32) + 0.06 * reliefOf({x, y, 3}, 0.4, seed + 48)};
    };
    site.walls.push_back(wallOf({kPlug, kPlug}, 1, plug, false));
    site.sizes = {330, 0.44, 0.55, 0.13, 1.9};
    site.start = [=](double sizeM, RandomSequence& of) -> Eigen::Vector3d {
        const Eigen::Vector2d flat = onCircle(radius(arch + 1.5) - sizeM, of);
        return {flat.x(), flat.y(), arch + dome + 1.8 + of.uniform(0, 0.6)};
    };
    site.isScanned = [](const Eigen::Vector3d& place) { return place.z() > 0.8; };
    site.firstLineDeg = -40.0;
    return site;
}

Site pile(std::uint64_t seed, RandomSequence& dice) {
    constexpr double kFloorM = -1.5;
    const double half = dice.uniform(2.2, 2.7), back = -dice.uniform(6.6, 7.6);
    const std::vector<Plane> planes{{{-9, -12, kFloorM}, {18, 0, 0}, {0, 14, 0}, {220, 170}, 0.7, 3},
                                    {{-half, -12, kFloorM - 0.3}, {0, 14, 0}, {0, 0, 6}, {200, 100}, 1.0, 2},
                                    {{half, 2, kFloorM - 0.3}, {0, -14, 0}, {0, 0, 6}, {200, 100}, 1.0, 2},
                                    {{half + 1, back, kFloorM - 0.3}, {-2 * half - 2, 0, 0}, {0, 0, 9}, {100, 140}, 2.0, 1},
                                    {{-half - 1, -4.2, 2.4}, {2 * half + 2, 0, 0}, {0, 6.5, 0}, {90, 100}, 1.0, 2}};
    Site site;
    for (const Plane& plane : planes) site.walls.push_back(planeWall(plane, seed));
    site.sizes = {420, 0.36, 0.55, 0.11, 1.5};
    site.start = [=](double sizeM, RandomSequence& of) -> Eigen::Vector3d {
        const double free = half - 0.6 * sizeM;
        const double x = 0.8 * of.uniform(-free, free);
        return {x, of.uniform(back + 0.6 + 0.5 * sizeM, back + 3.4), 3.4 + of.uniform(0, 0.8)};
    };
    site.isScanned = [](const Eigen::Vector3d& place) { return place.y() < -1.0 && place.norm() > 1.2; };
    site.firstLineDeg = 29.0;
    site.mountDeg = dice.uniform(28, 36);
    return site;
}

Site bench(std::uint64_t seed, RandomSequence& dice) {
    constexpr double kFloorM = -2.4;
    Site site;
    site.walls.push_back(planeWall({{-7, -7, kFloorM}, {14, 0, 0}, {0, 14, 0}, {260, 260}, 0.6, 3}, seed));
    site.sizes = {260, 0.26, 0.45, 0.09, 0.8};
    site.start = [=](double, RandomSequence& of) -> Eigen::Vector3d {
        const Eigen::Vector2d flat = onCircle(1.7, of);
        return {1.2 * flat.x(), flat.y() - 1.2, kFloorM + 1.6 + of.uniform(0, 0.6)};
    };
    site.isScanned = [](const Eigen::Vector3d& place) { return place.norm() > 0.6; };
    site.firstLineDeg = 0.0;
    site.mountDeg = dice.uniform(112, 124);
    return site;
}

} // namespace

const std::vector<std::string>& siteKinds() {
    static const std::vector<std::string> kinds{"bench", "hangup", "pile"};
    return kinds;
}

Result<Site> siteOf(const std::string& kind, std::uint64_t seed) {
    RandomSequence dice(seed, sim::Purpose::Walls);
    const std::uint64_t relief = sim::hashOf(seed, sim::Purpose::Walls, 1);
    if (kind == "hangup") return hangup(relief, dice);
    if (kind == "pile") return pile(relief, dice);
    if (kind == "bench") return bench(relief, dice);
    return Error{"there is no kind of scene \"" + kind + "\"", "stones", "use bench, hangup or pile"};
}

} // namespace edgescan::lab
