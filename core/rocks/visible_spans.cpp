// Calipers by the convex hull.
#include "core/rocks/visible_spans.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace edgescan {
namespace {

using Points = std::vector<Eigen::Vector2d>;

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
    const Eigen::Vector2d ab = b - a;
    const Eigen::Vector2d ac = c - a;
    return ab.x() * ac.y() - ab.y() * ac.x();
}

// Leaves out most of what lies inside: what is within the polygon of the farthest points of eight directions is no corner.
Points outermost(const Points& points) {
    static const std::array<Eigen::Vector2d, 8> kEightWays{{{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};
    std::array<Eigen::Vector2d, 8> corners;
    corners.fill(points.front());
    std::array<double, 8> farthest;
    farthest.fill(-HUGE_VAL);
    for (const Eigen::Vector2d& p : points) {
        for (std::size_t n = 0; n < kEightWays.size(); ++n) {
            const double along = kEightWays[n].dot(p);
            if (along <= farthest[n]) continue;
            farthest[n] = along;
            corners[n] = p;
        }
    }
    if (corners[0] == corners[4] && corners[2] == corners[6]) return {points.front()}; // they are all in one place
    Points left;
    for (const Eigen::Vector2d& p : points) {
        bool inside = true;
        for (std::size_t n = 0; n < corners.size(); ++n) {
            const Eigen::Vector2d& next = corners[(n + 1) % corners.size()];
            if (next != corners[n]) inside = inside && cross(corners[n], next, p) > 0;
        }
        if (!inside) left.push_back(p);
    }
    return left;
}

// Andrew's monotone chain, counter-clockwise.
Points hullOf(Points points) {
    std::sort(points.begin(), points.end(),
              [](const auto& p, const auto& q) { return p.x() < q.x() || (p.x() == q.x() && p.y() < q.y()); });
    Points hull;
    for (int half = 0; half < 2; ++half) {
        const std::size_t start = hull.size();
        for (const Eigen::Vector2d& p : points) {
            while (hull.size() >= start + 2 && cross(hull[hull.size() - 2], hull.back(), p) <= 0) hull.pop_back();
            hull.push_back(p);
        }
        hull.pop_back(); // it is the first of the other half
        std::reverse(points.begin(), points.end());
    }
    return hull;
}

} // namespace

Calipers calipersOf(const Points& points) {
    if (points.empty()) return {};
    const Points hull = hullOf(outermost(points));
    Calipers calipers;
    if (hull.size() < 2) return calipers;
    calipers.shortest = HUGE_VAL;
    for (std::size_t n = 0; n < hull.size(); ++n) {
        const Eigen::Vector2d& next = hull[(n + 1) % hull.size()];
        const double length = (next - hull[n]).norm();
        double across = 0;
        for (const Eigen::Vector2d& p : hull) {
            calipers.longest = std::max(calipers.longest, (p - hull[n]).norm());
            across = std::max(across, cross(hull[n], next, p));
        }
        if (length > 0) calipers.shortest = std::min(calipers.shortest, across / length);
    }
    return calipers;
}

} // namespace edgescan
