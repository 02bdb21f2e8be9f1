// Computes calipers from the convex hull.
#include "core/rocks/attributes/visible_spans.h"

#include "core/base/simd.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace edgescan::rocks {
namespace {

using Points = std::vector<Eigen::Vector2d>;

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
    const Eigen::Vector2d ab = b - a;
    const Eigen::Vector2d ac = c - a;
    return ab.x() * ac.y() - ab.y() * ac.x();
}

// 1 where a point is inside the polygon of eight corners.
EDGESCAN_INLINE void markInside(const double* x, const double* y, std::size_t count, const std::array<Eigen::Vector2d, 8>& corners,
                                std::uint8_t* __restrict inside) {
    for (std::size_t n = 0; n < count; ++n) inside[n] = 1;
    for (std::size_t c = 0; c < corners.size(); ++c) {
        const double fromX = corners[c].x();
        const double fromY = corners[c].y();
        const double alongX = corners[(c + 1) % corners.size()].x() - fromX;
        const double alongY = corners[(c + 1) % corners.size()].y() - fromY;
        if (alongX == 0 && alongY == 0) continue;
        for (std::size_t n = 0; n < count; ++n)
            inside[n] = static_cast<std::uint8_t>(inside[n] & (alongX * (y[n] - fromY) - alongY * (x[n] - fromX) > 0 ? 1 : 0));
    }
}

// Removes most of the inner points: a point inside the polygon of the farthest points in eight directions is not a corner.
Points outermost(const PlanePoints& points) {
    const auto& [x, y] = points;
    std::array<std::size_t, 8> at{};
    std::array<double, 8> farthest;
    farthest.fill(-HUGE_VAL);
    for (std::size_t n = 0; n < x.size(); ++n) {
        const double sum = x[n] + y[n];
        const double difference = y[n] - x[n];
        const std::array<double, 8> along{x[n], sum, y[n], difference, -x[n], -sum, -y[n], -difference};
        for (std::size_t way = 0; way < along.size(); ++way) {
            if (along[way] <= farthest[way]) continue;
            farthest[way] = along[way];
            at[way] = n;
        }
    }
    std::array<Eigen::Vector2d, 8> corners;
    for (std::size_t way = 0; way < corners.size(); ++way) corners[way] = {x[at[way]], y[at[way]]};
    if (corners[0] == corners[4] && corners[2] == corners[6]) return {corners[0]}; // all points coincide
    std::vector<std::uint8_t> inside(x.size());
    vectorised<markInside>(x.data(), y.data(), x.size(), corners, inside.data());
    Points left;
    for (std::size_t n = 0; n < x.size(); ++n) {
        if (inside[n] == 0) left.emplace_back(x[n], y[n]);
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
        hull.pop_back(); // it is the first point of the other half
        std::reverse(points.begin(), points.end());
    }
    return hull;
}

} // namespace

Calipers calipersOf(const PlanePoints& points) {
    if (points.x.empty()) return {};
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

} // namespace edgescan::rocks
