// Finds rims, sorts pairs of rim cells by length, and checks the space between them.
#include "core/inspect/measure/throat.h"

#include "core/base/order_statistic.h"
#include "core/inspect/measure/jumps_along.h"
#include "core/inspect/measure/near_side.h"
#include "core/rocks/segmentation/cuts.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <tuple>
#include <vector>

namespace edgescan::inspect {
namespace {

constexpr double kNearPicked = 0.25;       // share of the distance of the two cells
constexpr std::size_t kMostRimCells = 600; // per side; of more, evenly chosen ones
constexpr int kCellsAtEnds = 4;            // cells before and behind, for the straight lines at a jump
constexpr int kLeastWay = 20;              // cells that are searched for a nearer rim, also where the two picked cells are closer
constexpr int kWidestVoid = 7;             // cells without a range between two surfaces
constexpr int kFewestOnSurface = 4;        // of a surface: fewer are dust
constexpr int kMostTried = 4000;           // shortest pairs; if all of these are blocked, the result is empty
constexpr double kAtEnd = 0.02;            // of a way, where its surfaces are those of its ends
constexpr double kLeastBehind = 1.0;       // of the width: what is seen through an opening by one click, behind its sides
constexpr double kLeastDepth = 0.25;       // of the width: the least that half of an opening is deep

struct RimCell {
    std::uint32_t cell;
    Eigen::Vector3d pointM;
};

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
        constexpr int kHere = CellsAround::kReach;
        for (const auto& [di, dj] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}}) {
            if (!scan_.rangeMm.contains(line + di, beam + dj)) continue;
            if (scan_.state.at(line + di, beam + dj) != CellState::Valid) return true;
            const auto jumps = jumpsAlong(cellsAround(scan_, line, beam, di, dj).rangesM, 0);
            if (std::ranges::any_of(jumps, [](const RowJump& jump) { return jump.from == kHere && jump.stepM > 0.0; })) return true;
        }
        return false;
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

/// The angle between the two cells.
double openingRad(const CartesianTables& tables, std::uint32_t a, std::uint32_t b) {
    const Eigen::Vector3d first = tables.point(a) - tables.sensor(), second = tables.point(b) - tables.sensor();
    return std::atan2(first.cross(second).norm(), first.dot(second));
}

/// True if the two ranges differ by more than the opening is wide there: the farther one is not at the rim of the same opening.
bool isBehind(double rangeM, double otherM, double openingRad) { return rangeM - otherM > openingRad * std::max(rangeM, otherM); }

/// The rim of the opening at the side of `end`. A surface seen through the opening ends where a nearer one begins: from `end` away from
/// `other`, no farther than the two are apart, the first cell of a surface that is nearer by more than the opening is wide. Else `end`.
std::uint32_t rimBefore(const Scan& scan, const CartesianTables& tables, std::uint32_t end, std::uint32_t other) {
    const int beams = scan.beams();
    const int line = static_cast<int>(end) / beams, beam = static_cast<int>(end) % beams;
    const int lines = line - static_cast<int>(other) / beams, across = beam - static_cast<int>(other) % beams;
    const int apart = std::max(std::abs(lines), std::abs(across));
    std::vector<double> rangesM;
    std::vector<std::uint32_t> cells;
    for (int n = -kCellsAtEnds; n <= std::max(apart, kLeastWay) + kCellsAtEnds; ++n) {
        const int i = line + static_cast<int>(std::lround(static_cast<double>(n) * lines / apart));
        const int j = beam + static_cast<int>(std::lround(static_cast<double>(n) * across / apart));
        if (!scan.rangeMm.contains(i, j)) {
            if (n > 0) break;
            continue;
        }
        cells.push_back(static_cast<std::uint32_t>(scan.rangeMm.index(i, j)));
        rangesM.push_back(scan.state.at(i, j) == CellState::Valid ? static_cast<double>(scan.rangeMm.at(i, j)) / 1000.0 : 0.0);
    }
    const auto start = std::ranges::find(cells, end) - cells.begin();
    const double rangeM = static_cast<double>(scan.rangeMm[end]) / 1000.0, wide = openingRad(tables, end, other);
    const std::vector<RowJump> jumps = jumpsAlong(rangesM, kWidestVoid);
    for (const RowJump& jump : jumps) {
        const double nearM = rangesM[static_cast<std::size_t>(jump.to)];
        if (jump.from < start || jump.stepM >= 0.0 || !isBehind(rangeM, nearM, wide)) continue;
        const bool isDust = std::ranges::any_of(
            jumps, [&](const RowJump& next) { return next.from >= jump.to && next.from < jump.to + kFewestOnSurface && next.stepM > 0.0; });
        if (!isDust) return cells[static_cast<std::size_t>(jump.to)];
    }
    return end;
}

/// True if no cell was measured in front of the straight line between the two points or on it, and half of the cells between have the next
/// surface well behind the line: a hollow of a rock is not an opening.
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
    return behindM.empty() || median(behindM) > kLeastDepth * way.norm();
}

/// A click, and the four clicks next to it that a hand may do as well.
std::vector<std::uint32_t> clicksNear(const Scan& scan, std::uint32_t clicked) {
    const int line = static_cast<int>(clicked) / scan.beams(), beam = static_cast<int>(clicked) % scan.beams();
    std::vector<std::uint32_t> clicks;
    for (const auto& [di, dj] : {std::pair{0, 0}, {-1, 0}, {1, 0}, {0, -1}, {0, 1}}) {
        const int i = line + di * kClickSpread, j = beam + dj * kClickSpread;
        if (scan.rangeMm.contains(i, j)) clicks.push_back(static_cast<std::uint32_t>(scan.rangeMm.index(i, j)));
    }
    return clicks;
}

/// The cells that these clicks mean: that of the click itself first. Empty if nothing was measured there.
std::vector<std::uint32_t> meantNear(const Scan& scan, std::uint32_t clicked) {
    std::vector<std::uint32_t> meant;
    for (const std::uint32_t each : clicksNear(scan, clicked)) {
        const MeantCell click = meantCell(scan, each);
        if (click.measured())
            meant.push_back(click.cell);
        else if (meant.empty())
            return {};
    }
    return meant;
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

/// A straight way over the grid from a cell, up to `cells` cells in a direction whose larger part is 1. The first kCellsAtEnds cells are
/// before that cell.
struct WayOut {
    std::vector<std::uint32_t> cells;
    std::vector<double> rangesM; // 0 without a range
};

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

/// Places on the way where a nearer surface begins that hides a part of what is behind it; each is nearer than those before. Behind a cell
/// without a range, the first surface is one of them.
std::vector<std::size_t> nearerOn(const WayOut& way) {
    double nearestM = way.rangesM[kCellsAtEnds] > 0.0 ? way.rangesM[kCellsAtEnds] : std::numeric_limits<double>::infinity();
    std::vector<std::size_t> nearer;
    const std::vector<RowJump> jumps = jumpsAlong(way.rangesM, kWidestVoid);
    const auto begins = [&](std::size_t n) { // a surface, at the end of a jump or of a void over which a jump is not seen
        if (std::ranges::any_of(jumps, [&](const RowJump& jump) { return jump.stepM < 0.0 && static_cast<std::size_t>(jump.to) == n; }))
            return true;
        for (std::size_t back = 1; back <= kWidestVoid + 1; ++back) {
            if (n - back <= kCellsAtEnds) return way.rangesM[kCellsAtEnds] == 0.0 && way.rangesM[n - 1] == 0.0;
            if (way.rangesM[n - back] > 0.0) return false;
        }
        return true;
    };
    const auto isSurface = [&](std::size_t n) { // not dust
        if (n + kFewestOnSurface > way.rangesM.size()) return false;
        for (std::size_t m = n; m < n + kFewestOnSurface; ++m) {
            if (way.rangesM[m] == 0.0 || way.rangesM[m] - way.rangesM[n] > leastJumpM(way.rangesM[n]) * kFewestOnSurface) return false;
        }
        return true;
    };
    for (std::size_t n = kCellsAtEnds + 1; n < way.rangesM.size(); ++n) {
        if (way.rangesM[n] == 0.0 || !(nearestM - way.rangesM[n] > leastJumpM(way.rangesM[n])) || !begins(n) || !isSurface(n)) continue;
        nearestM = way.rangesM[n];
        nearer.push_back(n);
    }
    return nearer;
}

int reachOf(const Scan& scan) {
    constexpr int kShareOfScan = 4;
    return std::max(scan.lines(), scan.beams()) / kShareOfScan;
}

/// Of the cells where nearer surfaces begin at both ends of a straight way through `k`, the closest two with free space between them, if
/// the cell has no range or is farther behind them than they are apart: a hollow between rocks is not an opening.
std::optional<std::array<RimCell, 2>> sidesAlong(const Scan& scan, const CartesianTables& tables, std::uint32_t k, double lineStep,
                                                 double beamStep) {
    const std::array ways{wayOut(scan, k, lineStep, beamStep, reachOf(scan)), wayOut(scan, k, -lineStep, -beamStep, reachOf(scan))};
    std::vector<std::array<std::size_t, 2>> pairs;
    for (const std::size_t first : nearerOn(ways[0])) {
        for (const std::size_t second : nearerOn(ways[1])) pairs.push_back({first, second});
    }
    std::ranges::stable_sort(pairs, {}, [](const auto& pair) { return pair[0] + pair[1]; });
    for (const auto& [first, second] : pairs) {
        const std::uint32_t a = ways[0].cells[first], b = ways[1].cells[second];
        const double rangeA = ways[0].rangesM[first], rangeB = ways[1].rangesM[second], wide = openingRad(tables, a, b);
        if (isBehind(rangeA, rangeB, wide) || isBehind(rangeB, rangeA, wide)) continue;
        const std::array sides{RimCell{a, tables.point(a)}, RimCell{b, tables.point(b)}};
        const double rangeM = ways[0].rangesM[kCellsAtEnds], widthM = (sides[0].pointM - sides[1].pointM).norm();
        const bool isThrough = rangeM > 0.0 ? rangeM - (rangeA + rangeB) / 2.0 > kLeastBehind * widthM
                                            : first + second - 2 * kCellsAtEnds > kWidestVoid + 1; // else the surface goes on behind it
        if (isThrough && isOpen(scan, tables, sides[0], sides[1])) return sides;
    }
    return std::nullopt;
}

/// Two cells at opposite sides of the opening around a cell: on one of the straight ways through it, the first nearer surfaces at both ends
/// with free space between them; of these the two that are closest to each other.
std::optional<std::array<std::uint32_t, 2>> sidesAround(const Scan& scan, const CartesianTables& tables, std::uint32_t k) {
    constexpr int kDirections = 32; // over half a turn
    std::optional<std::array<std::uint32_t, 2>> closest;
    double closestM = std::numeric_limits<double>::infinity();
    for (int n = 0; n < kDirections; ++n) {
        const double angle = std::numbers::pi * n / kDirections, along = std::cos(angle), across = std::sin(angle);
        const double larger = std::max(std::abs(along), std::abs(across));
        const auto sides = sidesAlong(scan, tables, k, along / larger, across / larger);
        if (!sides) continue;
        const double lengthM = ((*sides)[0].pointM - (*sides)[1].pointM).norm();
        if (!(lengthM < closestM)) continue;
        closestM = lengthM;
        closest = {(*sides)[0].cell, (*sides)[1].cell};
    }
    return closest;
}

} // namespace

std::optional<std::array<std::uint32_t, 2>> narrowestBetween(const Scan& scan, const CartesianTables& tables, std::uint32_t a,
                                                             std::uint32_t b) {
    Rims rims(scan);
    return narrowestOf(scan, tables, rims, a, b);
}

std::optional<Throat> throatAt(const Scan& scan, const CartesianTables& tables, std::uint32_t clickedA, std::uint32_t clickedB) {
    if (clickedA >= scan.cells() || clickedB >= scan.cells()) return std::nullopt;
    const std::vector<std::uint32_t> firsts = meantNear(scan, clickedA), seconds = meantNear(scan, clickedB);
    if (firsts.empty() || seconds.empty()) return std::nullopt;
    std::set<std::array<std::uint32_t, 2>> tries;
    for (const std::uint32_t a : firsts) {
        for (const std::uint32_t b : seconds) tries.insert({a, b});
    }
    Rims rims(scan);
    struct Way {
        double lengthM;
        std::array<std::uint32_t, 2> ends;
    };
    std::vector<Way> ways;
    for (const auto& [a, b] : tries) {
        if (const auto ends = narrowestOf(scan, tables, rims, a, b))
            ways.push_back({(tables.point((*ends)[0]) - tables.point((*ends)[1])).norm(), *ends});
    }
    if (ways.empty()) return std::nullopt;
    std::ranges::sort(ways, [](const Way& x, const Way& y) { return std::tie(x.lengthM, x.ends) < std::tie(y.lengthM, y.ends); });
    return Throat{ways[ways.size() / 2].ends, ways.front().lengthM, ways.back().lengthM};
}

std::optional<Throat> throatThrough(const Scan& scan, const CartesianTables& tables, std::uint32_t clicked) {
    std::optional<Throat> throat;
    if (clicked >= scan.cells()) return throat;
    for (const std::uint32_t click : clicksNear(scan, clicked)) { // the click itself is the first
        const auto sides = sidesAround(scan, tables, click);
        if (!sides && !throat) return std::nullopt;
        if (!sides) continue;
        const double lengthM = (tables.point((*sides)[0]) - tables.point((*sides)[1])).norm();
        if (!throat) throat = Throat{*sides, lengthM, lengthM};
        throat->leastM = std::min(throat->leastM, lengthM);
        throat->mostM = std::max(throat->mostM, lengthM);
    }
    return throat;
}

} // namespace edgescan::inspect
