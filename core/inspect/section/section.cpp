// Cuts triangles of neighbouring cells by a plane and joins the pieces.
#include "core/inspect/section/section.h"

#include "core/base/angles.h"
#include "core/inspect/measure/jumps_along.h"
#include "core/rocks/attributes/attributes.h"
#include "core/scan/grid/cartesian.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

namespace edgescan::inspect {
namespace {

constexpr double kUpright = 0.05; // horizontal share of a way below which it is vertical

Error noPlane(const char* what) {
    return {std::string("no section can be drawn: ") + what, "", "choose two other cells that have a range"};
}

SectionPlane planeAlong(const Eigen::Vector3d& originM, const Eigen::Vector3d& way, const rocks::UpDirection& up) {
    SectionPlane plane;
    plane.originM = originM;
    plane.up = up.up.normalized();
    plane.across = (way - way.dot(plane.up) * plane.up).normalized();
    plane.upAssumed = up.assumed;
    return plane;
}

/// Two cells between which the plane passes; `first` is the smaller index.
using Side = std::pair<std::uint32_t, std::uint32_t>;
Side sideOf(std::uint32_t a, std::uint32_t b) { return {std::min(a, b), std::max(a, b)}; }

class Cutter {
public:
    Cutter(const edges::Detection& detection, const SectionPlane& plane, const Grid<std::uint32_t>* rockOf)
        : detection_(detection), scan_(*detection.scan), plane_(plane), normal_(plane.across.cross(plane.up)), rockOf_(rockOf),
          tables_(scan_) {}

    [[nodiscard]] std::vector<SectionLine> lines() {
        std::vector<double> above = heights(0), below;
        for (int i = 0; i + 1 < scan_.lines(); ++i) {
            below = heights(i + 1);
            for (int j = 0; j + 1 < scan_.beams(); ++j) {
                const auto n = static_cast<std::size_t>(j);
                cut(i, j, {above[n], above[n + 1], below[n]}, false);
                cut(i, j, {above[n + 1], below[n + 1], below[n]}, true);
            }
            above.swap(below);
        }
        return joined();
    }

private:
    /// Signed distances of a line's points from the plane; NaN without a range.
    [[nodiscard]] std::vector<double> heights(int line) const {
        const auto beams = static_cast<std::size_t>(scan_.beams());
        std::vector<double> x(beams), y(beams), z(beams), height(beams);
        tables_.pointsOfLine(line, x.data(), y.data(), z.data());
        for (std::size_t j = 0; j < beams; ++j) height[j] = (Eigen::Vector3d(x[j], y[j], z[j]) - plane_.originM).dot(normal_);
        return height;
    }
    /// The triangle of cell (i, j), its next beam and its next line; or the other half of the square.
    void cut(int i, int j, const std::array<double, 3>& height, bool otherHalf) {
        const bool anyAbove = height[0] > 0 || height[1] > 0 || height[2] > 0;
        const bool allAbove = height[0] > 0 && height[1] > 0 && height[2] > 0;
        if (!anyAbove || allAbove || !std::isfinite(height[0] + height[1] + height[2])) return;
        const auto cell = [&](int di, int dj) { return static_cast<std::uint32_t>(scan_.rangeMm.index(i + di, j + dj)); };
        const bool linked = otherHalf ? isOneSurface(scan_, i + 1, j, 0, 1) && isOneSurface(scan_, i, j + 1, 1, 0)
                                      : isOneSurface(scan_, i, j, 0, 1) && isOneSurface(scan_, i, j, 1, 0);
        if (!linked) return;
        const std::array corners =
            otherHalf ? std::array{cell(0, 1), cell(1, 1), cell(1, 0)} : std::array{cell(0, 0), cell(0, 1), cell(1, 0)};
        std::vector<Side> sides;
        for (std::size_t n = 0; n < 3; ++n) {
            const std::size_t m = (n + 1) % 3;
            if ((height[n] > 0) == (height[m] > 0)) continue;
            const Side side = sideOf(corners[n], corners[m]);
            sides.push_back(side);
            share_[side] = side.first == corners[n] ? height[n] / (height[n] - height[m]) : height[m] / (height[m] - height[n]);
        }
        next_[sides[0]].push_back(sides[1]);
        next_[sides[1]].push_back(sides[0]);
    }
    /// Each side belongs to two triangles at most.
    [[nodiscard]] std::vector<SectionLine> joined() {
        std::vector<SectionLine> lines;
        for (const bool fromEnds : {true, false}) { // lines with ends first, then closed ones
            for (const auto& [side, neighbours] : next_) {
                if (done_.contains(side) || (fromEnds && neighbours.size() != 1)) continue;
                SectionLine line;
                std::optional<Side> at = side;
                while (at) {
                    done_[*at] = true;
                    line.push_back(vertex(*at));
                    const auto& onward = next_.at(*at);
                    const auto next = std::ranges::find_if(onward, [&](const Side& other) { return !done_.contains(other); });
                    at = next == onward.end() ? std::nullopt : std::optional(*next);
                }
                if (neighbours.size() > 1 && line.size() > 2) line.push_back(line.front());
                lines.push_back(std::move(line));
            }
        }
        return lines;
    }
    [[nodiscard]] SectionVertex vertex(const Side& side) const {
        const double share = share_.at(side);
        SectionVertex vertex;
        vertex.pointM = (1.0 - share) * tables_.point(side.first) + share * tables_.point(side.second);
        vertex.atM = {(vertex.pointM - plane_.originM).dot(plane_.across), (vertex.pointM - plane_.originM).dot(plane_.up)};
        vertex.cell = share < 0.5 ? side.first : side.second;
        vertex.other = share < 0.5 ? side.second : side.first;
        vertex.share = std::min(share, 1.0 - share);
        for (const std::uint32_t k : {vertex.other, vertex.cell}) {
            if ((*detection_.mask)[k] == 0) continue;
            vertex.edge = true;
            if (detection_.classes) vertex.kind = (*detection_.classes)[k];
        }
        if (rockOf_ != nullptr) vertex.rock = (*rockOf_)[vertex.cell];
        return vertex;
    }

    const edges::Detection& detection_;
    const Scan& scan_;
    const SectionPlane& plane_;
    Eigen::Vector3d normal_;
    const Grid<std::uint32_t>* rockOf_;
    CartesianTables tables_;
    std::map<Side, double> share_; // of the way from the first cell to the second
    std::map<Side, std::vector<Side>> next_;
    std::map<Side, bool> done_;
};

} // namespace

Result<SectionPlane> planeThrough(const Scan& scan, std::uint32_t from, std::uint32_t to) {
    for (const std::uint32_t k : {from, to}) {
        if (k >= scan.cells() || scan.state[k] != CellState::Valid) return noPlane("one of its two cells has no range");
    }
    const CartesianTables tables(scan);
    const Eigen::Vector3d start = tables.point(from), way = tables.point(to) - start;
    if (!(way.norm() > 0.0)) return noPlane("its two cells are one point");
    const rocks::UpDirection up = rocks::upOf(scan);
    const auto level = [&](const Eigen::Vector3d& v) { return (v - v.dot(up.up) * up.up).norm(); };
    if (level(way) > kUpright * way.norm()) return planeAlong(start, way, up);
    const Eigen::Vector3d away = start - tables.sensor();
    if (!(level(away) > kUpright * away.norm())) return noPlane("its two cells are above each other and above the scanner");
    return planeAlong(start, away, up);
}

Result<SectionPlane> planeThroughRock(const Scan& scan, const std::vector<std::uint32_t>& rockCells) {
    const CartesianTables tables(scan);
    const rocks::UpDirection up = rocks::upOf(scan);
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    std::vector<Eigen::Vector3d> points;
    std::vector<std::uint32_t> beams;
    for (const std::uint32_t k : rockCells) {
        if (k >= scan.cells() || scan.state[k] != CellState::Valid) continue;
        points.push_back(tables.point(k));
        beams.push_back(k % static_cast<std::uint32_t>(scan.beams()));
        middle += points.back();
    }
    if (points.size() < 2) return noPlane("the rock has fewer than two points");
    middle /= static_cast<double>(points.size());
    // The direction, of a half turn in steps of a degree, in which the points spread most.
    const Eigen::Vector3d first = up.up.unitOrthogonal(), second = up.up.cross(first);
    double widest = 0.0;
    Eigen::Vector3d along = first, start = middle;
    for (int degree = 0; degree < 180; ++degree) {
        const double angle = radians(degree);
        const Eigen::Vector3d direction = std::cos(angle) * first + std::sin(angle) * second;
        double least = HUGE_VAL, most = -HUGE_VAL;
        std::uint32_t ofLeast = 0, ofMost = 0;
        for (std::size_t n = 0; n < points.size(); ++n) {
            const double at = direction.dot(points[n] - middle);
            if (at < least) std::tie(least, ofLeast) = std::pair(at, beams[n]);
            if (at > most) std::tie(most, ofMost) = std::pair(at, beams[n]);
        }
        if (most - least <= widest) continue;
        widest = most - least;
        const bool turned = ofLeast > ofMost;
        start = middle + (turned ? most : least) * direction;
        along = turned ? Eigen::Vector3d(-direction) : direction;
    }
    return planeAlong(start, along, up);
}

Section sectionOf(const edges::Detection& detection, const SectionPlane& plane, const Grid<std::uint32_t>* rockOf) {
    return {plane, Cutter(detection, plane, rockOf).lines()};
}

MeasuredLength sectionLength(const Scan& scan, const RangeNoise& noise, const SectionVertex& a, const SectionVertex& b) {
    return lengthBetween(scan, noise, {a.pointM, a.cell}, {b.pointM, b.cell});
}

} // namespace edgescan::inspect
