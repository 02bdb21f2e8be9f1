// Incremental convex hull: each point outside removes the triangles that it sees, and is joined to the rim of the hole.
#include "core/base/geometry/convex_hull.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace edgescan {
namespace {

using Points = std::vector<Eigen::Vector3d>;

const Eigen::Vector3d& at(const Points& points, int i) { return points[static_cast<std::size_t>(i)]; }

/// Signed height of the point over the plane of the triangle, positive outside.
double heightOver(const Points& points, const HullTriangle& triangle, int point) {
    const Eigen::Vector3d& a = at(points, triangle[0]);
    const Eigen::Vector3d normal = (at(points, triangle[1]) - a).cross(at(points, triangle[2]) - a);
    const double length = normal.norm();
    return length > 0.0 ? normal.dot(at(points, point) - a) / length : 0.0;
}

template <class Measure>
int farthest(const Points& points, Measure measure) {
    int best = 0;
    for (int i = 1; i < static_cast<int>(points.size()); ++i)
        if (measure(at(points, i)) > measure(at(points, best))) best = i;
    return best;
}

/// Four points far apart, with triangles that face outward; empty if all points are in one plane.
std::vector<HullTriangle> firstTetrahedron(const Points& points, double tolerance) {
    const Eigen::Vector3d origin = points.front();
    const int a = farthest(points, [&](const Eigen::Vector3d& p) { return (p - origin).squaredNorm(); });
    const Eigen::Vector3d pa = at(points, a);
    const int b = farthest(points, [&](const Eigen::Vector3d& p) { return (p - pa).squaredNorm(); });
    const Eigen::Vector3d axis = at(points, b) - pa;
    if (axis.norm() <= tolerance) return {};
    const int c = farthest(points, [&](const Eigen::Vector3d& p) { return axis.cross(p - pa).squaredNorm(); });
    const Eigen::Vector3d normal = axis.cross(at(points, c) - pa);
    if (normal.norm() <= tolerance * axis.norm()) return {};
    const int d = farthest(points, [&](const Eigen::Vector3d& p) { return std::abs(normal.dot(p - pa)); });
    const double height = normal.dot(at(points, d) - pa) / normal.norm();
    if (std::abs(height) <= tolerance) return {};
    if (height < 0.0) return {{a, b, c}, {a, d, b}, {b, d, c}, {c, d, a}};
    return {{a, c, b}, {a, b, d}, {b, c, d}, {c, a, d}};
}

/// The hull of the points of `triangles` and one more point.
std::vector<HullTriangle> grown(const Points& points, const std::vector<HullTriangle>& triangles, int point, double tolerance) {
    std::vector<HullTriangle> kept;
    std::vector<std::array<int, 2>> rim; // directed edges of removed triangles that do not belong to a second removed triangle
    for (const HullTriangle& triangle : triangles) {
        if (heightOver(points, triangle, point) <= tolerance) {
            kept.push_back(triangle);
            continue;
        }
        for (std::size_t e = 0; e < 3; ++e) {
            const std::array<int, 2> edge{triangle[e], triangle[(e + 1) % 3]};
            const auto twin = std::find(rim.begin(), rim.end(), std::array<int, 2>{edge[1], edge[0]});
            if (twin == rim.end())
                rim.push_back(edge);
            else
                rim.erase(twin);
        }
    }
    for (const auto& edge : rim) kept.push_back({edge[0], edge[1], point});
    return kept;
}

} // namespace

std::vector<HullTriangle> convexHull(const std::vector<Eigen::Vector3d>& points) {
    if (points.size() < 4) return {};
    double extent = 0.0;
    for (const Eigen::Vector3d& p : points) extent = std::max(extent, (p - points.front()).norm());
    const double tolerance = 1e-9 * extent;
    std::vector<HullTriangle> triangles = firstTetrahedron(points, tolerance);
    if (triangles.empty()) return {};
    for (int i = 0; i < static_cast<int>(points.size()); ++i) triangles = grown(points, triangles, i, tolerance);
    return triangles;
}

// The hull of these points is the dual of the body: each of its triangles corresponds to a corner.
std::vector<Eigen::Vector3d> cornersBetween(const std::vector<Eigen::Vector3d>& planes) {
    std::vector<Eigen::Vector3d> corners;
    for (const HullTriangle& t : convexHull(planes)) {
        const Eigen::Vector3d& a = planes[static_cast<std::size_t>(t[0])];
        const Eigen::Vector3d normal = (planes[static_cast<std::size_t>(t[1])] - a).cross(planes[static_cast<std::size_t>(t[2])] - a);
        corners.emplace_back(normal / normal.dot(a));
    }
    return corners;
}

std::vector<Eigen::Vector4d> planesOf(const std::vector<Eigen::Vector3d>& points, const std::vector<HullTriangle>& hull) {
    std::vector<Eigen::Vector4d> planes;
    for (const HullTriangle& t : hull) {
        const Eigen::Vector3d& a = points[static_cast<std::size_t>(t[0])];
        const Eigen::Vector3d normal =
            (points[static_cast<std::size_t>(t[1])] - a).cross(points[static_cast<std::size_t>(t[2])] - a).normalized();
        Eigen::Vector4d plane;
        plane << normal, normal.dot(a);
        const auto same = [&](const Eigen::Vector4d& other) { return (other - plane).cwiseAbs().maxCoeff() < 1e-5; };
        if (normal.squaredNorm() > 0.5 && std::none_of(planes.begin(), planes.end(), same)) planes.push_back(plane);
    }
    return planes;
}

} // namespace edgescan
