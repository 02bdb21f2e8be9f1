// Hulls that start from the outermost points in many directions and grow.
#include "core/rocks/attributes/hulls.h"

#include "core/base/geometry/convex_hull.h"
#include "core/rocks/attributes/cells.h"
#include "core/rocks/attributes/visible_surface.h"
#include "core/scan/grid/cartesian.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>
#include <span>

namespace edgescan::rocks {
namespace {

constexpr int kMostRounds = 40;

// 26 directions, to the corners, edges and sides of a cube.
std::vector<Eigen::Vector3d> directions() {
    std::vector<Eigen::Vector3d> ways;
    for (int x = -1; x <= 1; ++x) {
        for (int y = -1; y <= 1; ++y) {
            for (int z = -1; z <= 1; ++z) {
                if (x != 0 || y != 0 || z != 0) ways.push_back(Eigen::Vector3d(x, y, z).normalized());
            }
        }
    }
    return ways;
}

// Builds the hull of the chosen points. `outside` receives the indices of points outside the hull; the farthest of them over each triangle
// is added to the chosen points.
bool grow(const std::vector<Eigen::Vector3d>& points, std::vector<std::size_t>& chosen, std::vector<std::size_t>& outside,
          std::vector<HullTriangle>& triangles) {
    std::vector<Eigen::Vector3d> corners;
    for (const std::size_t n : chosen) corners.push_back(points[n]);
    triangles = convexHull(corners);
    std::vector<std::size_t> left;
    std::vector<std::size_t> farthest(triangles.size(), points.size());
    std::vector<double> height(triangles.size(), kHullToleranceM);
    std::vector<std::pair<Eigen::Vector3d, double>> planes;
    for (const HullTriangle& t : triangles) {
        const auto at = [&](std::size_t n) { return corners[static_cast<std::size_t>(t[n])]; };
        const Eigen::Vector3d normal = (at(1) - at(0)).cross(at(2) - at(0)).normalized();
        planes.emplace_back(normal, normal.dot(at(0)));
    }
    for (const std::size_t n : outside) {
        bool isOutside = false;
        for (std::size_t t = 0; t < planes.size(); ++t) {
            const double over = planes[t].first.dot(points[n]) - planes[t].second;
            if (over <= kHullToleranceM) continue;
            isOutside = true;
            if (over <= height[t]) continue;
            height[t] = over;
            farthest[t] = n;
        }
        if (isOutside) left.push_back(n);
    }
    outside = std::move(left);
    for (const std::size_t n : farthest) {
        if (n < points.size()) chosen.push_back(n);
    }
    std::sort(chosen.begin(), chosen.end());
    chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
    return !outside.empty() && !triangles.empty();
}

Hull hullOf(std::uint32_t label, std::span<const std::uint32_t> cells, const CartesianTables& tables) {
    static const std::vector<Eigen::Vector3d> kCubeWays = directions();
    Hull hull;
    hull.label = label;
    if (cells.empty()) return hull;
    std::vector<Eigen::Vector3d> points;
    for (const std::uint32_t k : cells) points.push_back(tables.point(k));
    std::vector<std::size_t> chosen;
    for (const Eigen::Vector3d& way : kCubeWays) {
        std::size_t best = 0;
        for (std::size_t n = 1; n < points.size(); ++n) {
            if (way.dot(points[n]) > way.dot(points[best])) best = n;
        }
        chosen.push_back(best);
    }
    std::sort(chosen.begin(), chosen.end());
    chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
    std::vector<std::size_t> outside(points.size());
    for (std::size_t n = 0; n < outside.size(); ++n) outside[n] = n;
    std::vector<HullTriangle> triangles;
    std::vector<std::size_t> corners = chosen;
    for (int round = 0; round < kMostRounds; ++round) {
        corners = chosen;
        if (!grow(points, chosen, outside, triangles)) break;
    }
    std::vector<std::uint32_t> place(corners.size(), std::numeric_limits<std::uint32_t>::max());
    for (const HullTriangle& triangle : triangles) {
        for (const int n : triangle) place[static_cast<std::size_t>(n)] = 0;
    }
    for (std::size_t n = 0; n < corners.size(); ++n) {
        if (place[n] != 0) continue;
        place[n] = static_cast<std::uint32_t>(hull.cells.size());
        hull.cells.push_back(cells[corners[n]]);
    }
    for (const HullTriangle& t : triangles)
        hull.triangles.push_back(
            {place[static_cast<std::size_t>(t[0])], place[static_cast<std::size_t>(t[1])], place[static_cast<std::size_t>(t[2])]});
    return hull;
}

} // namespace

std::vector<Hull> rockHulls(const Segmentation& segments, const RegionMap& map) {
    const CellsByRock cells = cellsByRock(segments, map);
    const Grid<std::uint32_t> visible = visibleSurfaces(segments, map);
    const CartesianTables tables(*segments.inputs.scan);
    std::vector<Hull> hulls;
    std::vector<std::uint32_t> seen;
    for (std::uint32_t label = 1; label <= map.rocks; ++label) {
        seen.clear();
        std::ranges::copy_if(cells.of(label), std::back_inserter(seen), [&](std::uint32_t k) { return visible[k] == label; });
        hulls.push_back(hullOf(label, seen, tables));
    }
    return hulls;
}

} // namespace edgescan::rocks
