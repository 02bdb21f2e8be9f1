// Finds rims, sorts pairs of rim cells by length, and checks the space between them.
#include "core/inspect/measure/throat.h"

#include "core/base/order_statistic.h"
#include "core/inspect/measure/jumps_along.h"
#include "core/inspect/measure/near_side.h"
#include "core/inspect/measure/open_way.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

namespace edgescan::inspect {
namespace {

constexpr double kNearPicked = 0.25;       // share of the distance of the two cells
constexpr std::size_t kMostRimCells = 600; // per side; of more, evenly chosen ones
constexpr int kLeastWay = 20;              // cells that are searched for a nearer rim, also where the two picked cells are closer
constexpr int kMostTried = 4000;           // shortest pairs; if all of these are blocked, the result is empty

/// Cells next to a farther surface or a void; each is looked at once, however often it is asked for.
class Rims {
public:
    explicit Rims(const Scan& scan) : scan_(scan), known_(scan.lines(), scan.beams()) {}
    [[nodiscard]] bool contains(int line, int beam) {
        std::uint8_t& known = known_.at(line, beam);
        if (known == kUnknown) known = isRim(line, beam) ? kRim : kNotRim;
        return known == kRim;
    }

private:
    static constexpr std::uint8_t kUnknown = 0, kRim = 1, kNotRim = 2;
    [[nodiscard]] bool isRim(int line, int beam) const {
        const auto k = static_cast<std::uint32_t>(scan_.rangeMm.index(line, beam));
        for (const auto& [di, dj] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}}) {
            if (scan_.rangeMm.contains(line + di, beam + dj) && endsAt(wayOut(scan_, k, di, dj, kWidestVoid + kCellsAtEnds).rangesM))
                return true;
        }
        return false;
    }

    /// True if the surface of the cell ends: at a jump to a farther one, or at a void that is wider than a few lost beams.
    [[nodiscard]] static bool endsAt(const std::vector<double>& rangesM) {
        const auto next = std::span(rangesM).subspan(kCellsAtEnds + 1);
        if (std::ranges::all_of(next.first(std::min<std::size_t>(next.size(), kWidestVoid + 1)), [](double m) { return m == 0.0; }))
            return true;
        return std::ranges::any_of(jumpsAlong(rangesM, kWidestVoid),
                                   [](const RowJump& jump) { return jump.from == kCellsAtEnds && jump.stepM > 0.0; });
    }

    const Scan& scan_;
    Grid<std::uint8_t> known_;
};

/// Rim cells within `reachM` of the cell. All of them are within the angle that the reach covers.
std::vector<RimCell> rimNear(const Scan& scan, const CartesianTables& tables, Rims& rims, std::uint32_t k, double reachM) {
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
                if (rims.contains(i, j)) rim.push_back({static_cast<std::uint32_t>(scan.rangeMm.index(i, j)), p});
            }
        }
        if (!any && ring > 3) break;
    }
    if (rim.size() <= kMostRimCells) return rim;
    std::vector<RimCell> some;
    for (std::size_t n = 0; n < kMostRimCells; ++n) some.push_back(rim[n * rim.size() / kMostRimCells]);
    return some;
}

/// The rim of the opening at the side of `end`. A surface seen through the opening ends where a nearer one begins: from `end` away from
/// `other`, no farther than the two are apart, the first cell of a surface that is nearer by more than the opening is wide. Else `end`.
std::uint32_t rimBefore(const Scan& scan, const CartesianTables& tables, std::uint32_t end, std::uint32_t other) {
    const int beams = scan.beams();
    const int line = static_cast<int>(end) / beams, beam = static_cast<int>(end) % beams;
    const int lines = line - static_cast<int>(other) / beams, across = beam - static_cast<int>(other) % beams;
    const int apart = std::max(std::abs(lines), std::abs(across));
    const WayOut way = wayOut(scan, end, static_cast<double>(lines) / apart, static_cast<double>(across) / apart,
                              std::max(apart, kLeastWay) + kCellsAtEnds);
    const double rangeM = static_cast<double>(scan.rangeMm[end]) / 1000.0, wide = openingRad(tables, end, other);
    const std::vector<RowJump> jumps = jumpsAlong(way.rangesM, kWidestVoid);
    for (const RowJump& jump : jumps) {
        const double nearM = way.rangesM[static_cast<std::size_t>(jump.to)];
        if (jump.from < kCellsAtEnds || jump.stepM >= 0.0 || !isBehind(rangeM, nearM, wide)) continue;
        const bool isDust = std::ranges::any_of(
            jumps, [&](const RowJump& next) { return next.from >= jump.to && next.from < jump.to + kFewestOnSurface && next.stepM > 0.0; });
        if (!isDust) return way.cells[static_cast<std::size_t>(jump.to)];
    }
    return end;
}

/// The cells that these clicks mean: that of the click itself first. Empty if nothing was measured there.
std::vector<std::uint32_t> nearSideCells(const Scan& scan, std::uint32_t clicked) {
    std::vector<std::uint32_t> cells;
    for (const std::uint32_t each : clicksNear(scan, clicked)) {
        const ClickedCell click = nearSideCell(scan, each);
        if (click.measured())
            cells.push_back(click.cell);
        else if (cells.empty())
            return {};
    }
    return cells;
}

std::optional<std::array<std::uint32_t, 2>> narrowestOf(const Scan& scan, const CartesianTables& tables, Rims& rims, std::uint32_t a,
                                                        std::uint32_t b) {
    if (a >= scan.cells() || b >= scan.cells() || scan.state[a] != CellState::Valid || scan.state[b] != CellState::Valid || a == b)
        return std::nullopt;
    const std::uint32_t pickedA = a;
    a = rimBefore(scan, tables, a, b);
    b = rimBefore(scan, tables, b, pickedA);
    const double rangeA = static_cast<double>(scan.rangeMm[a]) / 1000.0, rangeB = static_cast<double>(scan.rangeMm[b]) / 1000.0;
    if (const double wide = openingRad(tables, a, b); isBehind(rangeA, rangeB, wide) || isBehind(rangeB, rangeA, wide)) return std::nullopt;
    const double reachM = kNearPicked * (tables.point(a) - tables.point(b)).norm();
    const std::vector<RimCell> first = rimNear(scan, tables, rims, a, reachM), second = rimNear(scan, tables, rims, b, reachM);
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
        if (isOpen(scan, tables, first[pair.first], second[pair.second]))
            return std::array{first[pair.first].cell, second[pair.second].cell};
    }
    return std::nullopt;
}

} // namespace

std::vector<std::uint32_t> clicksNear(const Scan& scan, std::uint32_t clicked) {
    const int line = static_cast<int>(clicked) / scan.beams(), beam = static_cast<int>(clicked) % scan.beams();
    std::vector<std::uint32_t> clicks;
    for (const auto& [di, dj] : {std::pair{0, 0}, {-1, 0}, {1, 0}, {0, -1}, {0, 1}}) {
        const int i = line + di * kClickSpread, j = beam + dj * kClickSpread;
        if (scan.rangeMm.contains(i, j)) clicks.push_back(static_cast<std::uint32_t>(scan.rangeMm.index(i, j)));
    }
    return clicks;
}

std::optional<std::array<std::uint32_t, 2>> narrowestBetween(const Scan& scan, const CartesianTables& tables, std::uint32_t a,
                                                             std::uint32_t b) {
    Rims rims(scan);
    return narrowestOf(scan, tables, rims, a, b);
}

std::optional<Throat> throatAt(const Scan& scan, const CartesianTables& tables, std::uint32_t clickedA, std::uint32_t clickedB) {
    if (clickedA >= scan.cells() || clickedB >= scan.cells()) return std::nullopt;
    if (clickedA == clickedB) return throatThrough(scan, tables, clickedA);
    if (clickedA > clickedB) { // the same in both orders
        auto throat = throatAt(scan, tables, clickedB, clickedA);
        if (throat) std::swap(throat->ends[0], throat->ends[1]);
        return throat;
    }
    const std::vector<std::uint32_t> firsts = nearSideCells(scan, clickedA), seconds = nearSideCells(scan, clickedB);
    if (firsts.empty() || seconds.empty()) return std::nullopt;
    struct Way {
        double lengthM;
        std::array<std::uint32_t, 2> ends;
    };
    std::vector<Way> ways;
    const auto add = [&](const std::array<std::uint32_t, 2>& ends) {
        ways.push_back({(tables.point(ends[0]) - tables.point(ends[1])).norm(), ends});
    };
    Crossings crossings(scan, tables);
    std::set<std::array<std::uint32_t, 2>> sides, others;
    for (const std::uint32_t a : firsts) {
        for (const std::uint32_t b : seconds) {
            const auto into = openingBetween(scan, a, b);
            if (const auto across = into ? crossings.between(a, b, *into) : std::nullopt)
                add(*across);
            else if (const auto between = into ? sidesBetween(scan, tables, a, b, *into) : std::nullopt)
                sides.insert(*between);
            else
                others.insert({a, b});
        }
    }
    Rims rims(scan);
    const auto addNarrowest = [&](const std::set<std::array<std::uint32_t, 2>>& pairs) {
        for (const auto& [a, b] : pairs) {
            if (const auto ends = narrowestOf(scan, tables, rims, a, b)) add(*ends);
        }
    };
    addNarrowest(sides);
    // Pairs that miss an opening which most of the others find do not count.
    if (ways.empty() || 2 * others.size() > firsts.size() * seconds.size()) addNarrowest(others);
    if (ways.empty()) return std::nullopt;
    std::ranges::sort(ways, [](const Way& x, const Way& y) { return std::tie(x.lengthM, x.ends) < std::tie(y.lengthM, y.ends); });
    Throat throat{ways[ways.size() / 2].ends, ways.front().lengthM, ways.back().lengthM};
    const auto apartM = [&](std::uint32_t end, std::uint32_t click) { return (tables.point(end) - tables.point(click)).norm(); };
    const std::uint32_t first = firsts.front(), second = seconds.front();
    // The first end is that of the first click.
    auto& [a, b] = throat.ends;
    if (apartM(b, first) + apartM(a, second) < apartM(a, first) + apartM(b, second)) std::swap(a, b);
    return throat;
}

} // namespace edgescan::inspect
