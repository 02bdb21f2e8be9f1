// Finds rims, sorts pairs of rim cells by length, and checks the space between them.
#include "core/inspect/measure/throat.h"

#include "core/inspect/measure/jumps_along.h"
#include "core/rocks/segmentation/cuts.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

namespace edgescan::inspect {
namespace {

constexpr double kNearPicked = 0.25;       // share of the distance of the two cells
constexpr std::size_t kMostRimCells = 600; // per side; of more, evenly chosen ones
constexpr int kMostTried = 4000;           // shortest pairs; if all of these are blocked, the result is empty

struct RimCell {
    std::uint32_t cell;
    Eigen::Vector3d pointM;
};

bool isRim(const Scan& scan, int line, int beam) {
    constexpr int kHere = CellsAround::kReach;
    for (const auto& [di, dj] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}}) {
        if (!scan.rangeMm.contains(line + di, beam + dj)) continue;
        if (scan.state.at(line + di, beam + dj) != CellState::Valid) return true;
        const auto jumps = jumpsAlong(cellsAround(scan, line, beam, di, dj).rangesM, 0);
        if (std::ranges::any_of(jumps, [](const RowJump& jump) { return jump.from == kHere && jump.stepM > 0.0; })) return true;
    }
    return false;
}

/// Rim cells within `reachM` of the cell. All of them are within the angle that the reach covers.
std::vector<RimCell> rimNear(const Scan& scan, const CartesianTables& tables, std::uint32_t k, double reachM) {
    const int line = static_cast<int>(k) / scan.beams(), beam = static_cast<int>(k) % scan.beams();
    const Eigen::Vector3d at = tables.point(k);
    std::vector<RimCell> rim;
    // Grows ring by ring until a whole ring has no cell within reach.
    for (int ring = 0; ring < std::max(scan.lines(), scan.beams()); ++ring) {
        bool any = false;
        for (int i = std::max(0, line - ring); i <= std::min(scan.lines() - 1, line + ring); ++i) {
            const bool whole = i == line - ring || i == line + ring;
            const int from = whole ? std::max(0, beam - ring) : beam - ring;
            const int last = whole ? std::min(scan.beams() - 1, beam + ring) : beam + ring;
            for (int j = from; j <= last; j += whole || ring == 0 ? 1 : 2 * ring) {
                if (!scan.rangeMm.contains(i, j) || scan.state.at(i, j) != CellState::Valid) continue;
                const Eigen::Vector3d p = tables.point(i, j);
                if (!((p - at).norm() <= reachM)) continue;
                any = true;
                if (isRim(scan, i, j)) rim.push_back({static_cast<std::uint32_t>(scan.rangeMm.index(i, j)), p});
            }
        }
        if (!any && ring > 3) break;
    }
    if (rim.size() <= kMostRimCells) return rim;
    std::vector<RimCell> some;
    for (std::size_t n = 0; n < kMostRimCells; ++n) some.push_back(rim[n * rim.size() / kMostRimCells]);
    return some;
}

/// True if no cell was measured in front of the straight line between the two points, or on it.
bool isFree(const Scan& scan, const CartesianTables& tables, const RimCell& from, const RimCell& to) {
    const std::vector<std::uint32_t> cells = rocks::strokeCells({from.cell, to.cell}, scan.lines(), scan.beams());
    const Eigen::Vector3d sensor = tables.sensor();
    const Eigen::Vector3d way = to.pointM - from.pointM;
    for (const std::uint32_t k : cells) {
        if (k == from.cell || k == to.cell || scan.state[k] != CellState::Valid) continue;
        const Eigen::Vector3d ray = (tables.point(k) - sensor).normalized();
        // The point of the line nearest to the ray; both start at known points.
        const Eigen::Vector3d off = from.pointM - sensor;
        const double along = ray.dot(way), square = way.squaredNorm();
        const double det = square - along * along;
        if (det < 1e-12) continue;
        const double t = std::clamp((along * ray.dot(off) - way.dot(off)) / det, 0.0, 1.0);
        const double passes = ray.dot(off + t * way);
        if (static_cast<double>(scan.rangeMm[k]) / 1000.0 <= passes && t > 0.02 && t < 0.98) return false;
    }
    return true;
}

} // namespace

std::optional<std::array<std::uint32_t, 2>> narrowestBetween(const Scan& scan, const CartesianTables& tables, std::uint32_t a,
                                                             std::uint32_t b) {
    if (a >= scan.cells() || b >= scan.cells() || scan.state[a] != CellState::Valid || scan.state[b] != CellState::Valid || a == b)
        return std::nullopt;
    const double reachM = kNearPicked * (tables.point(a) - tables.point(b)).norm();
    const std::vector<RimCell> first = rimNear(scan, tables, a, reachM), second = rimNear(scan, tables, b, reachM);
    struct Pair {
        double squareM2;
        std::uint32_t first, second; // indices
    };
    std::vector<Pair> pairs;
    pairs.reserve(first.size() * second.size());
    for (std::uint32_t m = 0; m < first.size(); ++m) {
        for (std::uint32_t n = 0; n < second.size(); ++n) pairs.push_back({(first[m].pointM - second[n].pointM).squaredNorm(), m, n});
    }
    const auto shorter = [](const Pair& x, const Pair& y) {
        return std::tie(x.squareM2, x.first, x.second) < std::tie(y.squareM2, y.first, y.second);
    };
    // As a heap: the shortest free pair is usually found early.
    const auto longer = [&](const Pair& x, const Pair& y) { return shorter(y, x); };
    std::ranges::make_heap(pairs, longer);
    for (int tried = 0; tried < kMostTried && !pairs.empty(); ++tried) {
        std::ranges::pop_heap(pairs, longer);
        const Pair pair = pairs.back();
        pairs.pop_back();
        if (isFree(scan, tables, first[pair.first], second[pair.second]))
            return std::array{first[pair.first].cell, second[pair.second].cell};
    }
    return std::nullopt;
}

} // namespace edgescan::inspect
