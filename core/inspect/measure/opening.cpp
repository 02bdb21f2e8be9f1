// The middle of an opening, and the shortest way across it.
#include "core/inspect/measure/jumps_along.h"
#include "core/inspect/measure/open_way.h"
#include "core/inspect/measure/throat.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

namespace edgescan::inspect {
namespace {

constexpr double kLeastBehind = 1.0; // of the width: what is seen through an opening, behind its sides

/// Places on the way where a nearer surface begins that hides a part of what is behind it; each is nearer than those before. Behind a cell
/// without a range, the first surface is one of them.
std::vector<std::size_t> nearerOn(const WayOut& way, double nearerThanM) {
    const double clickedM = way.rangesM[kCellsAtEnds];
    double nearestM = std::min(nearerThanM, clickedM > 0.0 ? clickedM : std::numeric_limits<double>::infinity());
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

/// Of the cell where two ways begin; of a single void, which is in a surface, that of the surface. 0: a wide void.
double rangeAtStart(const std::array<WayOut, 2>& ways) {
    const auto firstOn = [](const WayOut& way) {
        const auto found = std::find_if(way.rangesM.begin() + kCellsAtEnds, way.rangesM.end(), [](double rangeM) { return rangeM > 0.0; });
        return static_cast<std::size_t>(found - way.rangesM.begin());
    };
    const std::size_t first = firstOn(ways[0]), second = firstOn(ways[1]);
    const bool wide = first + second - 2 * kCellsAtEnds > kWidestVoid + 1;
    if (wide || first == ways[0].rangesM.size() || second == ways[1].rangesM.size()) return 0.0;
    return std::max(ways[0].rangesM[first], ways[1].rangesM[second]);
}

/// Of the cells where nearer surfaces begin at both ends of a straight way through `k`, the closest two with free space between them, if
/// the cell is in a wide void or farther behind them than they are apart: a hollow between rocks is not an opening.
std::optional<std::array<RimCell, 2>> sidesAlong(const Scan& scan, const CartesianTables& tables, std::uint32_t k, double lineStep,
                                                 double beamStep, double nearerThanM) {
    const std::array ways{wayOut(scan, k, lineStep, beamStep, reachOf(scan)), wayOut(scan, k, -lineStep, -beamStep, reachOf(scan))};
    std::vector<std::array<std::size_t, 2>> pairs;
    for (const std::size_t first : nearerOn(ways[0], nearerThanM)) {
        for (const std::size_t second : nearerOn(ways[1], nearerThanM)) pairs.push_back({first, second});
    }
    std::ranges::stable_sort(pairs, {}, [](const auto& pair) { return pair[0] + pair[1]; });
    const double rangeM = rangeAtStart(ways);
    for (const auto& [first, second] : pairs) {
        const std::uint32_t a = ways[0].cells[first], b = ways[1].cells[second];
        const double rangeA = ways[0].rangesM[first], rangeB = ways[1].rangesM[second], wide = openingRad(tables, a, b);
        if (isBehind(rangeA, rangeB, wide) || isBehind(rangeB, rangeA, wide)) continue;
        const std::array sides{RimCell{a, tables.point(a)}, RimCell{b, tables.point(b)}};
        const double widthM = (sides[0].pointM - sides[1].pointM).norm();
        const bool isThrough = rangeM == 0.0 || rangeM - (rangeA + rangeB) / 2.0 > kLeastBehind * widthM;
        if (isThrough && isOpen(scan, tables, sides[0], sides[1])) return sides;
    }
    return std::nullopt;
}

/// Two cells at opposite sides of the opening around a cell: on one of the straight ways through it, the first nearer surfaces at both ends
/// with free space between them; of these the two that are closest to each other. Both are nearer than `nearerThanM`.
std::optional<std::array<std::uint32_t, 2>> sidesAround(const Scan& scan, const CartesianTables& tables, std::uint32_t k,
                                                        double nearerThanM = std::numeric_limits<double>::infinity()) {
    constexpr int kDirections = 32; // over half a turn
    std::optional<std::array<std::uint32_t, 2>> closest;
    double closestM = std::numeric_limits<double>::infinity();
    for (int n = 0; n < kDirections; ++n) {
        const double angle = std::numbers::pi * n / kDirections, along = std::cos(angle), across = std::sin(angle);
        const double larger = std::max(std::abs(along), std::abs(across));
        const auto sides = sidesAlong(scan, tables, k, along / larger, across / larger, nearerThanM);
        if (!sides) continue;
        const double lengthM = ((*sides)[0].pointM - (*sides)[1].pointM).norm();
        if (!(lengthM < closestM)) continue;
        closestM = lengthM;
        closest = {(*sides)[0].cell, (*sides)[1].cell};
    }
    return closest;
}

/// The cells of the opening around a cell: those without a range or farther away than `fartherThanM`, each next to another one of them. The
/// opening is not closed if they reach far around the cell, or the border of the scan.
class OpeningCells {
public:
    OpeningCells(const Scan& scan, const CartesianTables& tables, std::uint32_t k, double fartherThanM)
        : scan_(scan), tables_(tables), fartherThanM_(fartherThanM), known_(scan.lines(), scan.beams()) {
        const int reach = reachOf(scan), beams = scan.beams(), line = static_cast<int>(k) / beams, beam = static_cast<int>(k) % beams;
        std::vector<std::uint32_t> open{k};
        known_[k] = kInside;
        while (!open.empty()) {
            const int i = static_cast<int>(open.back()) / beams, j = static_cast<int>(open.back()) % beams;
            open.pop_back();
            for (const auto& [di, dj] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}}) {
                if (!known_.contains(i + di, j + dj) || std::max(std::abs(i + di - line), std::abs(j + dj - beam)) > 2 * reach) {
                    isClosed_ = false;
                    return;
                }
                const auto next = static_cast<std::uint32_t>(known_.index(i + di, j + dj));
                if (known_[next] != 0) continue;
                known_[next] = isBehindSides(next) ? kInside : kSide;
                if (known_[next] == kInside) open.push_back(next);
                if (known_[next] == kSide && isOfSurface(i + di, j + dj)) sides_.push_back(tables_.direction(i + di, j + dj));
            }
        }
    }
    [[nodiscard]] bool isClosed() const { return isClosed_ && !sides_.empty(); }

    /// Uphill in the distance to the nearest side, from circle to circle: the middle of the part of the opening around the cell, and not
    /// that of a wider part behind a narrow place.
    [[nodiscard]] std::uint32_t middle(std::uint32_t k) const {
        constexpr int kMostSteps = 30;
        constexpr double kLooksPerCircle = 400.0, kLeastCircle = 3.0; // cells, so that it leaves a side
        double square = squareToSide(k);
        for (int step = 0; step < kMostSteps; ++step) {
            const double least = kLeastCircle * std::ranges::max(stepsAt(k));
            const std::vector<std::uint32_t> circle = cellsWithin(k, std::max(square, least * least));
            const auto every = static_cast<std::size_t>(std::ceil(static_cast<double>(circle.size()) / kLooksPerCircle));
            std::uint32_t best = k;
            for (std::size_t n = 0; n < circle.size(); n += every) {
                const double there = squareToSide(circle[n]);
                if (there <= square) continue;
                square = there;
                best = circle[n];
            }
            if (best == k) break;
            k = best;
        }
        return k;
    }

private:
    static constexpr std::uint8_t kInside = 1, kSide = 2;
    [[nodiscard]] bool isBehindSides(std::uint32_t k) const {
        return scan_.state[k] != CellState::Valid || static_cast<double>(scan_.rangeMm[k]) / 1000.0 > fartherThanM_;
    }
    /// Not a single echo in the opening.
    [[nodiscard]] bool isOfSurface(int line, int beam) const {
        constexpr int kFewest = 3; // of eight neighbours
        int near = 0;
        for (int di = -1; di <= 1; ++di) {
            for (int dj = -1; dj <= 1; ++dj) {
                if ((di != 0 || dj != 0) && known_.contains(line + di, beam + dj))
                    near += isBehindSides(static_cast<std::uint32_t>(known_.index(line + di, beam + dj))) ? 0 : 1;
            }
        }
        return near >= kFewest;
    }
    [[nodiscard]] Eigen::Vector3d direction(std::uint32_t k) const {
        return tables_.direction(static_cast<int>(k) / scan_.beams(), static_cast<int>(k) % scan_.beams());
    }
    /// Radians to the next line, and to the next beam.
    [[nodiscard]] std::array<double, 2> stepsAt(std::uint32_t k) const {
        const auto beams = static_cast<std::uint32_t>(scan_.beams());
        const Eigen::Vector3d here = direction(k);
        return {(direction(k >= beams ? k - beams : k + beams) - here).norm(), (direction(k % beams > 0 ? k - 1 : k + 1) - here).norm()};
    }
    [[nodiscard]] double squareToSide(std::uint32_t k) const {
        const Eigen::Vector3d here = direction(k);
        double least = std::numeric_limits<double>::infinity();
        for (const Eigen::Vector3d& side : sides_) least = std::min(least, (side - here).squaredNorm());
        return least;
    }
    /// Of the opening, by rows.
    [[nodiscard]] std::vector<std::uint32_t> cellsWithin(std::uint32_t k, double square) const {
        const int line = static_cast<int>(k) / scan_.beams(), beam = static_cast<int>(k) % scan_.beams(), reach = reachOf(scan_);
        const Eigen::Vector3d here = direction(k);
        const auto span = [&](double stepRad) { // cells, with room for uneven steps
            const double cells = 2.0 * std::sqrt(square) / stepRad + 2.0;
            return cells < reach ? static_cast<int>(cells) : reach;
        };
        const auto [lineRad, beamRad] = stepsAt(k);
        const int high = span(lineRad), wide = span(beamRad);
        std::vector<std::uint32_t> cells;
        for (int i = std::max(0, line - high); i <= std::min(scan_.lines() - 1, line + high); ++i) {
            for (int j = std::max(0, beam - wide); j <= std::min(scan_.beams() - 1, beam + wide); ++j) {
                const auto at = static_cast<std::uint32_t>(known_.index(i, j));
                if (known_[at] == kInside && (direction(at) - here).squaredNorm() < square) cells.push_back(at);
            }
        }
        return cells;
    }

    const Scan& scan_;
    const CartesianTables& tables_;
    double fartherThanM_;
    Grid<std::uint8_t> known_; // 0: not looked at
    std::vector<Eigen::Vector3d> sides_;
    bool isClosed_ = true;
};

double lengthM(const CartesianTables& tables, const std::array<std::uint32_t, 2>& ends) {
    return (tables.point(ends[0]) - tables.point(ends[1])).norm();
}

/// What is seen through the opening around a click is farther away than this, metres. `sides`: at the click.
double behindOf(const Scan& scan, const CartesianTables& tables, std::uint32_t k, const std::array<std::uint32_t, 2>& sides) {
    const auto rangeM = [&](std::uint32_t at) { return static_cast<double>(scan.rangeMm[at]) / 1000.0; };
    const double sidesM = (rangeM(sides[0]) + rangeM(sides[1])) / 2.0;
    const double behindM = scan.state[k] == CellState::Valid ? (rangeM(k) - sidesM) / 2.0 : 0.0;
    return sidesM + std::max(behindM, kLeastBehind * lengthM(tables, sides));
}

/// The middle of the opening around a click, and the sides of the shortest way through it.
struct Middle {
    std::uint32_t cell;
    double behindM; ///< behindOf()
    std::array<std::uint32_t, 2> sides;
    bool isClosed; ///< else the cell is the click
};

std::optional<Middle> middleUphill(const Scan& scan, const CartesianTables& tables, std::uint32_t clicked) {
    std::uint32_t seen = clicked;
    auto atClick = sidesAround(scan, tables, seen);
    if (!atClick) return std::nullopt;
    if (scan.state[clicked] != CellState::Valid) { // a void in a surface that is seen through an opening means that opening
        for (const std::uint32_t end : std::array(*atClick)) {
            const auto around = sidesAround(scan, tables, end);
            if (!around) continue;
            seen = end;
            atClick = around;
            break;
        }
    }
    const double behindM = behindOf(scan, tables, seen, *atClick);
    const OpeningCells opening(scan, tables, clicked, behindM);
    const std::uint32_t middle = opening.isClosed() ? opening.middle(clicked) : clicked;
    return Middle{middle, behindM, sidesAround(scan, tables, middle, behindM).value_or(*atClick), opening.isClosed()};
}

/// The middles of clicks, in which middleUphill() is asked once per cell: clicks next to each other lead to the same cells.
class Middles {
public:
    Middles(const Scan& scan, const CartesianTables& tables) : scan_(scan), tables_(tables) {}

    /// A click far from the middle sees other sides and another surface through the opening than the middle itself: from middle to middle,
    /// while the way gets shorter.
    [[nodiscard]] std::optional<Middle> around(std::uint32_t clicked) {
        constexpr int kMostSteps = 4;
        auto middle = uphill(clicked);
        for (int step = 0; step < kMostSteps && middle && middle->isClosed; ++step) {
            const std::array<std::uint32_t, 2>& ends = middle->sides;
            const auto beams = static_cast<std::uint32_t>(scan_.beams());
            const std::uint32_t between = (ends[0] / beams + ends[1] / beams) / 2 * beams + (ends[0] % beams + ends[1] % beams) / 2;
            const auto next = uphill(between);
            if (!next || !next->isClosed || lengthM(tables_, next->sides) >= lengthM(tables_, ends)) break;
            middle = next;
        }
        return middle;
    }

private:
    [[nodiscard]] std::optional<Middle> uphill(std::uint32_t k) {
        const auto [at, isNew] = uphill_.try_emplace(k);
        if (isNew) at->second = middleUphill(scan_, tables_, k);
        return at->second;
    }

    const Scan& scan_;
    const CartesianTables& tables_;
    std::map<std::uint32_t, std::optional<Middle>> uphill_;
};

/// Of one click; the least and the most are of clicks next to the middle.
std::optional<Throat> acrossMiddle(const Scan& scan, const CartesianTables& tables, Middles& middles, std::uint32_t clicked) {
    const auto middle = middles.around(clicked);
    if (!middle) return std::nullopt;
    Throat throat{middle->sides, lengthM(tables, middle->sides), lengthM(tables, middle->sides)};
    for (const std::uint32_t near : clicksNear(scan, middle->cell)) {
        const auto sides = sidesAround(scan, tables, near, middle->behindM);
        if (!sides) continue;
        throat.leastM = std::min(throat.leastM, lengthM(tables, *sides));
        throat.mostM = std::max(throat.mostM, lengthM(tables, *sides));
    }
    return throat;
}

/// Lines and beams from `a` to `b`.
std::array<int, 2> stepsBetween(const Scan& scan, std::uint32_t a, std::uint32_t b) {
    const int beams = scan.beams(), from = static_cast<int>(a), to = static_cast<int>(b);
    return {to / beams - from / beams, to % beams - from % beams};
}

/// True if, for the scanner, the straight line between the first two cells crosses that between the second two, or its middle part.
bool areAcross(const CartesianTables& tables, const std::array<std::uint32_t, 2>& first, const std::array<std::uint32_t, 2>& second) {
    constexpr double kMiddlePart = 0.25; // of the second line, to both sides of its middle
    const auto toward = [&](std::uint32_t k) { return Eigen::Vector3d((tables.point(k) - tables.sensor()).normalized()); };
    const Eigen::Vector3d a = toward(first[0]), b = toward(first[1]), c = toward(second[0]), d = toward(second[1]);
    const Eigen::Vector3d across = a.cross(b).normalized(), along = c.cross(d).normalized(), middle = (c + d).normalized();
    if (across.dot(c) * across.dot(d) <= 0.0 && along.dot(a) * along.dot(b) <= 0.0) return true;
    return a.cross(middle).dot(across) >= 0.0 && middle.cross(b).dot(across) >= 0.0 &&
           std::abs(across.dot(middle)) <= kMiddlePart * (c - d).norm();
}

} // namespace

std::optional<std::uint32_t> openingBetween(const Scan& scan, std::uint32_t a, std::uint32_t b) {
    const auto [lines, across] = stepsBetween(scan, a, b);
    const int apart = std::max(std::abs(lines), std::abs(across));
    if (apart < 2 || scan.state[a] != CellState::Valid || scan.state[b] != CellState::Valid) return std::nullopt;
    const WayOut way = wayOut(scan, a, static_cast<double>(lines) / apart, static_cast<double>(across) / apart, apart);
    int farthest = 0, run = 0, longest = kWidestVoid;
    double farthestM = 0.0;
    for (int n = 1; n < apart; ++n) {
        const double here = way.rangesM[static_cast<std::size_t>(n + kCellsAtEnds)];
        run = here == 0.0 ? run + 1 : 0;
        if (run > longest) {
            longest = run;
            farthest = n - run / 2;
            farthestM = std::numeric_limits<double>::infinity();
        } else if (here > farthestM) {
            farthest = n;
            farthestM = here;
        }
    }
    if (farthest == 0) return std::nullopt;
    return way.cells[static_cast<std::size_t>(farthest + kCellsAtEnds)];
}

std::optional<std::array<std::uint32_t, 2>> sidesBetween(const Scan& scan, const CartesianTables& tables, std::uint32_t a, std::uint32_t b,
                                                         std::uint32_t into) {
    const auto [line, beam] = stepsBetween(scan, a, b);
    const int apart = std::max(std::abs(line), std::abs(beam));
    const auto rangeM = [&](std::uint32_t k) { return static_cast<double>(scan.rangeMm[k]) / 1000.0; };
    const double nearerThanM = std::max(rangeM(a), rangeM(b)) + kLeastBehind / 2.0 * lengthM(tables, {a, b});
    const auto sides = sidesAlong(scan, tables, into, static_cast<double>(line) / apart, static_cast<double>(beam) / apart, nearerThanM);
    if (!sides) return std::nullopt;
    return std::array{(*sides)[1].cell, (*sides)[0].cell};
}

std::optional<std::array<std::uint32_t, 2>> Crossings::between(std::uint32_t a, std::uint32_t b, std::uint32_t into) {
    const auto [at, isNew] = sides_.try_emplace(into);
    if (isNew) {
        if (const auto middle = Middles(scan_, tables_).around(into); middle && middle->isClosed) at->second = middle->sides;
    }
    if (!at->second || !areAcross(tables_, {a, b}, *at->second)) return std::nullopt;
    return at->second;
}

bool isIntoOpening(const Scan& scan, const CartesianTables& tables, std::uint32_t k) {
    return k < scan.cells() && sidesAround(scan, tables, k).has_value();
}

std::optional<std::uint32_t> openingOfClick(const Scan& scan, const CartesianTables& tables, const ClickedCell& click) {
    if (isIntoOpening(scan, tables, click.cell)) return click.cell;
    if (click.clicked >= scan.cells()) return std::nullopt;
    const int line = static_cast<int>(click.clicked) / scan.beams(), beam = static_cast<int>(click.clicked) % scan.beams();
    std::vector<std::pair<int, std::uint32_t>> voids; // square of the cells between, and the cell
    for (int di = -kSnapReach; di <= kSnapReach; ++di) {
        for (int dj = -kSnapReach; dj <= kSnapReach; ++dj) {
            const bool isVoid = scan.rangeMm.contains(line + di, beam + dj) && scan.state.at(line + di, beam + dj) == CellState::NoReturn;
            const int square = di * di + dj * dj;
            if (isVoid && square <= kSnapReach * kSnapReach)
                voids.emplace_back(square, static_cast<std::uint32_t>(scan.rangeMm.index(line + di, beam + dj)));
        }
    }
    std::ranges::sort(voids);
    const auto into = std::ranges::find_if(voids, [&](const auto& each) { return isIntoOpening(scan, tables, each.second); });
    return into == voids.end() ? std::nullopt : std::optional(into->second);
}

std::optional<Throat> throatThrough(const Scan& scan, const CartesianTables& tables, std::uint32_t clicked) {
    if (clicked >= scan.cells()) return std::nullopt;
    Middles middles(scan, tables);
    std::optional<Throat> throat;
    for (const std::uint32_t click : clicksNear(scan, clicked)) { // the click itself is the first
        const auto here = acrossMiddle(scan, tables, middles, click);
        if (!here && !throat) return std::nullopt;
        if (!here) continue;
        if (!throat) throat = here;
        throat->leastM = std::min(throat->leastM, here->leastM);
        throat->mostM = std::max(throat->mostM, here->mostM);
    }
    return throat;
}

} // namespace edgescan::inspect
