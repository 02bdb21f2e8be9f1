// Scan lines among points that are not a full grid: rings of a spinning scanner, planes of a fan on a stepper.
#include "core/files/grid_recovery/parts.h"
#include "core/files/grid_recovery/regrid_parts.h"
#include "core/files/grid_recovery/rings.h"

#include <algorithm>
#include <array>

namespace edgescan::files::regridding {
namespace {

using recognition::AxisPoint;
using recognition::kPi;
using recognition::Ring;

constexpr double kShareOnLines = 0.99;
constexpr std::size_t kFewestLines = 4;
constexpr std::size_t kPointsPerLine = 12; // on average, at least
constexpr std::size_t kSample = 60000;     // points of a first look: lines that do not show here do not exist

std::vector<AxisPoint> axisPointsOf(const LooseCloud& cloud, int axis) {
    std::vector<AxisPoint> seen;
    seen.reserve(cloud.points.size());
    for (const Eigen::Vector3d& p : cloud.points) {
        const Eigen::Vector3d ray = p - cloud.sensor;
        if (isReturn(p) && isReturn(ray))
            seen.push_back({ray[axis], ray[(axis + 1) % 3], ray[(axis + 2) % 3]});
        else
            seen.emplace_back();
    }
    return seen;
}

/// The clearest ring of groups that holds nearly all angles, among every `stride`-th point.
template <class Angle>
std::optional<Ring> linesAmong(const std::vector<AxisPoint>& points, std::size_t stride, double period, Angle angleOf) {
    std::vector<double> angles;
    for (std::size_t k = 0; k < points.size(); k += stride) {
        if (!points[k].missing()) angles.push_back(angleOf(points[k]));
    }
    for (Ring& ring : recognition::ringsIn(angles, period)) {
        if (ring.centres.size() < kFewestLines || angles.size() < ring.centres.size() * kPointsPerLine) continue;
        const auto on = std::count_if(angles.begin(), angles.end(), [&](double angle) {
            const Ring::Nearest near = ring.nearest(angle);
            return near.distance <= 0.25 * near.voidWidth;
        });
        if (static_cast<double>(on) >= kShareOnLines * static_cast<double>(angles.size())) return std::move(ring);
    }
    return std::nullopt;
}

template <class Angle>
std::optional<Ring> linesIn(const std::vector<AxisPoint>& points, double period, Angle angleOf) {
    const std::size_t stride = points.size() / kSample | 1U; // odd, so that no place within a row is skipped
    if (stride > 1 && !linesAmong(points, stride, period, angleOf)) return std::nullopt;
    return linesAmong(points, 1, period, angleOf);
}

/// Rings about the upright axis: cones of one elevation each, as a spinning scanner with several beams leaves them.
std::optional<Fan> rings(const std::vector<AxisPoint>& points) {
    const auto elevation = [](const AxisPoint& p) { return std::asin(std::clamp(p.u / p.range(), -1.0, 1.0)); };
    const auto ring = linesIn(points, 2 * kPi, elevation);
    if (!ring) return std::nullopt;
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (const AxisPoint& p : points) sum += p.missing() ? Eigen::Vector2d::Zero() : Eigen::Vector2d(p.v, p.w).normalized();
    const double middle = std::atan2(sum.y(), sum.x());
    Fan fan;
    fan.lineAngle.assign(ring->centres.rbegin(), ring->centres.rend()); // the highest first
    for (std::uint32_t k = 0; k < points.size(); ++k) {
        const AxisPoint& p = points[k];
        if (p.missing()) continue;
        const auto line = static_cast<double>(ring->centres.size() - 1 - ring->nearest(elevation(p)).group);
        fan.sights.push_back({-std::remainder(p.plane() - middle, 2 * kPi), line, p.range(), k});
    }
    return fan;
}

/// Planes through an axis: a fan that was turned step by step.
std::optional<Fan> planes(const std::vector<AxisPoint>& points) {
    const auto plane = [](const AxisPoint& p) { return p.plane(); };
    const auto ring = linesIn(points, kPi, plane);
    if (!ring) return std::nullopt;
    Fan fan;
    fan.lineAngle = ring->centres;
    for (std::uint32_t k = 0; k < points.size(); ++k) {
        const AxisPoint& p = points[k];
        if (p.missing()) continue;
        const std::size_t line = ring->nearest(p.plane()).group;
        const double radius = p.radiusIn(std::cos(ring->centres[line]), std::sin(ring->centres[line]));
        fan.sights.push_back({std::atan2(radius, p.u), static_cast<double>(line), p.range(), k});
    }
    return fan;
}

} // namespace

std::optional<Fan> findFan(const LooseCloud& cloud) {
    static constexpr std::array<int, 3> kUprightFirst{2, 0, 1};
    for (const int axis : kUprightFirst) {
        const std::vector<AxisPoint> points = axisPointsOf(cloud, axis);
        if (axis == 2) {
            if (auto fan = rings(points)) return fan;
        }
        if (auto fan = planes(points)) return fan;
    }
    return std::nullopt;
}

} // namespace edgescan::files::regridding
