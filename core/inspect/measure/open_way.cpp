// Straight ways over the grid of a scan.
#include "core/inspect/measure/open_way.h"

#include "core/base/order_statistic.h"
#include "core/rocks/segmentation/cuts.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace edgescan::inspect {
namespace {

constexpr double kAtEnd = 0.02;        // of a way, where its surfaces are those of its ends
constexpr double kLeastDepth = 0.25;   // of the width: the least that half of an opening is deep
constexpr double kShallow = 0.2;       // share of the cells between two sides whose surfaces may be nearer to the line than
constexpr double kLeastAtSides = 0.08; // of the width

} // namespace

WayOut wayOut(const Scan& scan, std::uint32_t k, double lineStep, double beamStep, int cells) {
    const int line = static_cast<int>(k) / scan.beams(), beam = static_cast<int>(k) % scan.beams();
    WayOut way;
    for (int n = -kCellsAtEnds; n <= cells; ++n) {
        const int i = line + static_cast<int>(std::lround(n * lineStep)), j = beam + static_cast<int>(std::lround(n * beamStep));
        const bool isInside = scan.rangeMm.contains(i, j);
        if (n > 0 && !isInside) break;
        const auto at = isInside ? static_cast<std::uint32_t>(scan.rangeMm.index(i, j)) : 0U;
        way.cells.push_back(at);
        way.rangesM.push_back(isInside && scan.state[at] == CellState::Valid ? static_cast<double>(scan.rangeMm[at]) / 1000.0 : 0.0);
    }
    return way;
}

double openingRad(const CartesianTables& tables, std::uint32_t a, std::uint32_t b) {
    const Eigen::Vector3d first = tables.point(a) - tables.sensor(), second = tables.point(b) - tables.sensor();
    return std::atan2(first.cross(second).norm(), first.dot(second));
}

bool isBehind(double rangeM, double otherM, double openingRad) { return rangeM - otherM > openingRad * std::max(rangeM, otherM); }

bool isOpen(const Scan& scan, const CartesianTables& tables, const RimCell& from, const RimCell& to) {
    const Eigen::Vector3d way = to.pointM - from.pointM, off = from.pointM - tables.sensor();
    std::vector<double> behindM; // the surfaces of these cells, behind the line; endless without a range
    for (const std::uint32_t k : rocks::strokeCells({from.cell, to.cell}, scan.lines(), scan.beams())) {
        if (k == from.cell || k == to.cell) continue;
        if (scan.state[k] != CellState::Valid) {
            behindM.push_back(std::numeric_limits<double>::infinity());
            continue;
        }
        const Eigen::Vector3d ray = (tables.point(k) - tables.sensor()).normalized();
        // The point of the line nearest to the ray; both start at known points.
        const double along = ray.dot(way), square = way.squaredNorm();
        const double det = square - along * along;
        if (det < 1e-12) continue;
        const double t = std::clamp((along * ray.dot(off) - way.dot(off)) / det, 0.0, 1.0);
        if (t <= kAtEnd || t >= 1.0 - kAtEnd) continue;
        behindM.push_back(static_cast<double>(scan.rangeMm[k]) / 1000.0 - ray.dot(off + t * way));
        if (behindM.back() <= 0.0) return false;
    }
    return behindM.empty() || (median(behindM) > kLeastDepth * way.norm() && quantile(behindM, kShallow) > kLeastAtSides * way.norm());
}

} // namespace edgescan::inspect
