// The morphological opening of a convex polyhedron by a ball, and its volume by Steiner's formula.
#include "app/lab/sim/rounded_core.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

namespace edgescan::sim {
namespace {

constexpr double kFlat = 1e-4;      // radians: triangles of one side
constexpr double kShortestM = 1e-5; // where four sides meet, rounding gives two corners this close to each other

const Eigen::Vector3d& at(const std::vector<Eigen::Vector3d>& points, int i) { return points[static_cast<std::size_t>(i)]; }

/// Twice the area, along the outward normal.
Eigen::Vector3d areaOf(const std::vector<Eigen::Vector3d>& corners, const HullTriangle& t) {
    return (at(corners, t[1]) - at(corners, t[0])).cross(at(corners, t[2]) - at(corners, t[0]));
}

double volumeOf(const RoundedCore& core) {
    double six = 0.0;
    for (const HullTriangle& t : core.hull) six += at(core.corners, t[0]).dot(at(core.corners, t[1]).cross(at(core.corners, t[2])));
    return six / 6.0;
}

/// Finds the ridges; returns the sum of their lengths multiplied by the angles between their sides.
double findRidges(RoundedCore& core) {
    std::map<std::array<int, 2>, Eigen::Vector3d> waiting; // the first side of each edge, until the second one is found
    double bend = 0.0;
    for (const HullTriangle& t : core.hull) {
        const Eigen::Vector3d normal = areaOf(core.corners, t).normalized();
        for (std::size_t e = 0; e < 3; ++e) {
            const std::array<int, 2> edge{std::min(t[e], t[(e + 1) % 3]), std::max(t[e], t[(e + 1) % 3])};
            const auto other = waiting.find(edge);
            if (other == waiting.end()) {
                waiting.emplace(edge, normal);
                continue;
            }
            const double turn = std::atan2(normal.cross(other->second).norm(), normal.dot(other->second));
            const double length = (at(core.corners, edge[0]) - at(core.corners, edge[1])).norm();
            if (turn < kFlat || length < kShortestM) continue;
            core.ridges.push_back(edge);
            bend += turn * length;
        }
    }
    return bend;
}

} // namespace

RoundedCore roundedCore(const std::vector<Eigen::Vector3d>& corners, const std::vector<HullTriangle>& hull, double share) {
    RoundedCore core{corners, hull, {}, 0.0, 0.0};
    core.volumeM3 = volumeOf(core);
    if (share <= 0.0) return core;
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& corner : corners) middle += corner / static_cast<double>(corners.size());
    const std::vector<Eigen::Vector4d> sides = planesOf(corners, hull);
    double inner = std::numeric_limits<double>::infinity();
    for (const Eigen::Vector4d& side : sides) inner = std::min(inner, side.w() - side.head<3>().dot(middle));
    core.radiusM = share * inner;
    std::vector<Eigen::Vector3d> planes;
    for (const Eigen::Vector4d& side : sides) {
        const Eigen::Vector3d normal = side.head<3>();
        planes.emplace_back(normal / (side.w() - normal.dot(middle) - core.radiusM));
    }
    core.corners = cornersBetween(planes);
    for (Eigen::Vector3d& corner : core.corners) corner += middle;
    core.hull = convexHull(core.corners);
    const double r = core.radiusM;
    const double bend = findRidges(core);
    double area = 0.0;
    for (const HullTriangle& t : core.hull) area += 0.5 * areaOf(core.corners, t).norm();
    core.volumeM3 = volumeOf(core) + r * area + r * r * bend / 2.0 + r * r * r * 4.0 / 3.0 * std::numbers::pi;
    return core;
}

} // namespace edgescan::sim
