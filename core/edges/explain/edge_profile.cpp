// The points on both sides of a cell.
#include "core/edges/explain/edge_profile.h"

#include "core/scan/grid/cartesian.h"

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <iterator>
#include <span>
#include <utility>

namespace edgescan::edges {
namespace {

constexpr std::size_t kMostStray = 2;  // of more points that are far from the others the profile shows a jump
constexpr double kFarFromOthers = 2.0; // times what the others span
constexpr double kThinM = 0.02;        // a plain surface, with its noise

constexpr std::size_t kFitted = 6, kLeastFitted = 3;

bool isFar(double gap, double others) { return gap > kFarFromOthers * std::max(others, kThinM); }

/// Points from the cell outwards: those before a jump between them, or behind one that is nearer to the cell than a line needs.
std::vector<ProfilePoint> ofOneSurface(std::vector<ProfilePoint> points) {
    const auto spanOf = [&points](std::size_t first, std::size_t end) {
        const auto [least, most] = std::ranges::minmax(std::span(points).subspan(first, end - first), {}, &ProfilePoint::awayM);
        return most.awayM - least.awayM;
    };
    for (std::size_t n = 1; n < points.size(); ++n) {
        const double gap = std::abs(points[n].awayM - points[n - 1].awayM);
        const bool enough = n >= kLeastFitted;
        if (!isFar(gap, enough ? spanOf(0, n) : spanOf(n, points.size()))) continue;
        if (enough) {
            points.resize(n);
        } else if (points.size() - n >= kLeastFitted) {
            points.erase(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(n));
            n = 0;
        }
    }
    return points;
}

std::optional<ProfileLine> lineThrough(const std::vector<ProfilePoint>& points) {
    if (points.size() < kLeastFitted) return std::nullopt;
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    for (const ProfilePoint& p : points) middle += Eigen::Vector2d(p.acrossM, p.awayM);
    middle /= static_cast<double>(points.size());
    Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
    for (const ProfilePoint& p : points) {
        const Eigen::Vector2d from = Eigen::Vector2d(p.acrossM, p.awayM) - middle;
        spread += from * from.transpose();
    }
    const Eigen::Vector2d way = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(spread).eigenvectors().col(1);
    double least = 0.0, most = 0.0;
    for (const ProfilePoint& p : points) {
        const double at = way.dot(Eigen::Vector2d(p.acrossM, p.awayM) - middle);
        least = std::min(least, at);
        most = std::max(most, at);
    }
    const Eigen::Vector2d from = middle + least * way, to = middle + most * way;
    return ProfileLine{from.x(), from.y(), to.x(), to.y(), static_cast<int>(points.size())};
}

} // namespace

EdgeProfile edgeProfile(const Scan& scan, std::size_t k, Along along, int reach) {
    EdgeProfile profile;
    profile.along = along;
    if (scan.state[k] != CellState::Valid) return profile;
    const CartesianTables tables(scan);
    const int line = static_cast<int>(k / static_cast<std::size_t>(scan.beams())),
              beam = static_cast<int>(k % static_cast<std::size_t>(scan.beams()));
    const auto cellAt = [&](int steps) -> std::optional<std::size_t> {
        const int l = along == Along::Lines ? line + steps : line, b = along == Along::Beams ? beam + steps : beam;
        if (l < 0 || l >= scan.lines() || b < 0 || b >= scan.beams() || scan.state.at(l, b) != CellState::Valid) return std::nullopt;
        return scan.rangeMm.index(l, b);
    };
    const Eigen::Vector3d own = tables.point(k), away = (own - tables.sensor()).normalized();
    // The beams of the profile define a plane with the cell's own beam. The direction across the beam is taken from the farthest of them.
    Eigen::Vector3d across = Eigen::Vector3d::Zero();
    for (int steps = reach; steps > 0 && across.isZero(); --steps) {
        for (const int way : {1, -1}) {
            if (const auto other = cellAt(way * steps); other && across.isZero()) {
                const Eigen::Vector3d beamThere = (tables.point(*other) - tables.sensor()).normalized();
                across = way * (beamThere - away * away.dot(beamThere));
            }
        }
    }
    if (across.norm() < 1e-12) return profile;
    across.normalize();
    for (int steps = -reach; steps <= reach; ++steps) {
        const auto cell = cellAt(steps);
        if (!cell) continue;
        const Eigen::Vector3d from = tables.point(*cell) - own;
        profile.points.push_back({*cell, steps < 0 ? -1 : steps > 0 ? 1 : 0, across.dot(from), away.dot(from)});
    }
    for (const int side : {-1, 1}) {
        std::vector<ProfilePoint> those;
        std::ranges::copy_if(profile.points, std::back_inserter(those), [side](const ProfilePoint& p) { return p.side == side; });
        if (side < 0) std::ranges::reverse(those);
        if (those.size() > kFitted) those.resize(kFitted);
        profile.sides[side < 0 ? 0 : 1] = lineThrough(ofOneSurface(std::move(those)));
    }
    return profile;
}

DepthsShown depthsShown(const EdgeProfile& profile) {
    const auto own = std::ranges::find(profile.points, 0, &ProfilePoint::side);
    std::vector<double> depths;
    for (auto point = profile.points.begin(); point != profile.points.end(); ++point) {
        if (own == profile.points.end() || std::abs(point - own) <= static_cast<std::ptrdiff_t>(kFitted)) depths.push_back(point->awayM);
    }
    if (depths.empty()) return {};
    std::ranges::sort(depths);
    std::size_t first = 0, last = depths.size() - 1; // of those that are shown; the cell itself is at depth 0
    for (std::size_t left = kMostStray; left > 0; --left) {
        if (last < first + left + 1) continue;
        const std::size_t end = last - left, start = first + left;
        if (depths[end + 1] > 0.0 && isFar(depths[end + 1] - depths[end], depths[end] - depths[first])) last = end;
        if (start < last && depths[start - 1] < 0.0 && isFar(depths[start] - depths[start - 1], depths[last] - depths[start]))
            first = start;
    }
    return {depths[first], depths[last]};
}

} // namespace edgescan::edges
