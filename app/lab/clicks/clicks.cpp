// Compares lengths between clicks with lengths between the true points that were meant.
#include "app/lab/clicks/clicks.h"

#include "app/lab/sim/random.h"
#include "app/lab/sim/truth/truth.h"
#include "core/inspect/measure/lengths.h"
#include "core/inspect/measure/near_side.h"

#include <algorithm>
#include <array>
#include <climits>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace edgescan::lab {
namespace {

constexpr int kAside = 2;          // cells from the edge
constexpr float kJumpMm = 50.0F;   // of the truth
constexpr double kBehindMm = 50.0; // an end that is farther behind the surface that was meant is on another one

struct Cell {
    int line = 0, beam = 0;
    bool operator==(const Cell&) const = default;
    auto operator<=>(const Cell&) const = default;
};

/// The true surface in front of an edge.
class TrueSurfaces {
public:
    explicit TrueSurfaces(const sim::SimulationTruth& truth) : truth_(truth) {}

    /// The cells around an edge's cell that are connected with it without a jump.
    [[nodiscard]] std::set<Cell> frontOf(Cell edge) const {
        std::set<Cell> reached{edge};
        std::vector<Cell> open{edge};
        while (!open.empty()) {
            const Cell at = open.back();
            open.pop_back();
            for (const auto& [di, dj] : {std::pair{0, 1}, {1, 0}, {0, -1}, {-1, 0}}) {
                const Cell next{at.line + di, at.beam + dj};
                if (std::abs(next.line - edge.line) > kAround || std::abs(next.beam - edge.beam) > kAround) continue;
                if (!isHit(next) || !isLinked(at, next) || !reached.insert(next).second) continue;
                open.push_back(next);
            }
        }
        return reached;
    }
    /// The cell of the front nearest to another cell; this itself if it is on the front or on a surface nearer than that.
    [[nodiscard]] Cell onFront(const std::set<Cell>& front, Cell at) const {
        Cell best = *front.begin();
        int least = INT_MAX;
        for (const Cell& cell : front) {
            const int square = (cell.line - at.line) * (cell.line - at.line) + (cell.beam - at.beam) * (cell.beam - at.beam);
            if (square < least || (square == least && rangeMm(cell) < rangeMm(best))) std::tie(least, best) = std::pair(square, cell);
        }
        return isHit(at) && rangeMm(at) < rangeMm(best) ? at : best;
    }
    [[nodiscard]] double rangeMm(Cell at) const { return static_cast<double>(truth_.cleanMm.at(at.line, at.beam)); }

private:
    [[nodiscard]] bool isHit(Cell at) const { return truth_.object.contains(at.line, at.beam) && truth_.object.at(at.line, at.beam) != 0; }
    [[nodiscard]] bool isLinked(Cell a, Cell b) const {
        if (b < a) std::swap(a, b);
        const Grid<sim::Seam>& seams = a.line == b.line ? truth_.toNextBeam : truth_.toNextLine;
        return isHit(a) && isHit(b) && seams.at(a.line, a.beam).tearMm <= kJumpMm;
    }

    static constexpr int kAround = kAside + inspect::kSnapReach; // cells
    const sim::SimulationTruth& truth_;
};

struct Click {
    std::uint32_t cell = 0;
    inspect::ClickedCell nearSide;
    std::set<Cell> front; ///< the true surface that was meant
};

class Clicks {
public:
    explicit Clicks(const sim::Simulation& simulation)
        : scan_(simulation.scan), surfaces_(*simulation.truth), tables_(scan_), noise_(rangeNoise(inverseRange(scan_))),
          rims_(nearSides(simulation)) {}
    [[nodiscard]] bool any() const { return !rims_.empty(); }
    [[nodiscard]] const Scan& scan() const { return scan_; }

    [[nodiscard]] Click click(std::uint64_t seed, std::uint64_t n) const {
        for (std::uint64_t attempt = 0;; ++attempt) {
            const std::uint64_t chance = sim::mixed(sim::mixed(seed) ^ sim::mixed(n * 1000003 + attempt));
            const Cell rim = cellOf(rims_[chance % rims_.size()]);
            const std::uint64_t aside = sim::mixed(chance);
            constexpr std::uint64_t kSide = 2 * kAside + 1;
            const Cell at{rim.line + static_cast<int>(aside % kSide) - kAside, rim.beam + static_cast<int>(aside / kSide % kSide) - kAside};
            if (!scan_.rangeMm.contains(at.line, at.beam)) continue;
            const auto k = static_cast<std::uint32_t>(scan_.rangeMm.index(at.line, at.beam));
            return {k, inspect::nearSideCell(scan_, k), surfaces_.frontOf(rim)};
        }
    }

    /// Both clicks measured at these cells.
    void measure(const Click& a, const Click& b, std::uint32_t from, std::uint32_t to, ClickedLengths& lengths) const {
        const auto measured = inspect::measureCells(scan_, noise_, inspect::MeasureKind::Distance, std::array{from, to});
        if (!measured) {
            ++lengths.refused;
            return;
        }
        ++lengths.measured;
        const inspect::MeasuredLength& length = measured->lengths.front();
        const double trueM = (truePoint(a, from) - truePoint(b, to)).norm();
        const double beyondM = length.isBelow ? trueM - length.smallestM : std::abs(length.valueM - trueM);
        const auto isDoubtful = [](const Click& click, std::uint32_t cell) {
            return cell == click.nearSide.cell && click.nearSide.alsoNear;
        };
        lengths.tolerancesM.push_back(length.toleranceM);
        const bool isWarned = measured->behindM > 0.0 || isDoubtful(a, from) || isDoubtful(b, to);
        lengths.warned += isWarned ? 1 : 0;
        lengths.offSilently += beyondM > length.toleranceM && !isWarned ? 1 : 0;
        lengths.off += beyondM > length.toleranceM ? 1 : 0;
        if (!isBehind(a, from) && !isBehind(b, to)) return;
        ++lengths.behind;
        lengths.silent += isWarned ? 0 : 1;
    }

private:
    [[nodiscard]] Cell cellOf(std::uint32_t k) const { return {static_cast<int>(k) / scan_.beams(), static_cast<int>(k) % scan_.beams()}; }
    /// Of the surface that was meant, without noise: on the rays of the measured cell and of its four neighbours, because the beam covers a
    /// rim that its middle misses. Of these points the one nearest to the measured one.
    [[nodiscard]] Eigen::Vector3d truePoint(const Click& click, std::uint32_t measured) const {
        const Cell at = cellOf(measured);
        Eigen::Vector3d best = pointAt(surfaces_.onFront(click.front, at));
        for (const auto& [di, dj] : {std::pair{0, 1}, {1, 0}, {0, -1}, {-1, 0}}) {
            const Cell next{at.line + di, at.beam + dj};
            if (surfaces_.onFront(click.front, next) != next) continue;
            const Eigen::Vector3d point = pointAt(next);
            if ((point - tables_.point(measured)).norm() < (best - tables_.point(measured)).norm()) best = point;
        }
        return best;
    }
    [[nodiscard]] Eigen::Vector3d pointAt(Cell at) const {
        return tables_.sensor() + surfaces_.rangeMm(at) / 1000.0 * tables_.direction(at.line, at.beam);
    }
    /// On another surface, behind the one that was meant. An end on a surface in front of that is not, however far it is behind its rim.
    [[nodiscard]] bool isBehind(const Click& click, std::uint32_t measured) const {
        const Cell at = cellOf(measured), meant = surfaces_.onFront(click.front, at);
        const double trueMm = 1000.0 * (truePoint(click, measured) - tables_.sensor()).norm();
        return meant != at && static_cast<double>(scan_.rangeMm[measured]) - std::max(trueMm, surfaces_.rangeMm(meant)) > kBehindMm;
    }

    const Scan& scan_;
    TrueSurfaces surfaces_;
    CartesianTables tables_;
    RangeNoise noise_;
    std::vector<std::uint32_t> rims_;
};

} // namespace

std::vector<std::uint32_t> nearSides(const sim::Simulation& simulation) {
    const sim::EdgeTruth truth = sim::edgeTruth(*simulation.truth);
    std::vector<std::uint32_t> cells;
    for (std::size_t k = 0; k < truth.edgeClass.size(); ++k) {
        const auto kind = static_cast<sim::EdgeClass>(truth.edgeClass[k]);
        const bool isRim = kind == sim::EdgeClass::Occluding || kind == sim::EdgeClass::Void;
        if (isRim && truth.ignore[k] == 0) cells.push_back(static_cast<std::uint32_t>(k));
    }
    return cells;
}

ClickedLengths& ClickedLengths::operator+=(const ClickedLengths& other) {
    tolerancesM.insert(tolerancesM.end(), other.tolerancesM.begin(), other.tolerancesM.end());
    refused += other.refused;
    measured += other.measured;
    off += other.off;
    offSilently += other.offSilently;
    warned += other.warned;
    behind += other.behind;
    silent += other.silent;
    return *this;
}

ClickScore& ClickScore::operator+=(const ClickScore& other) {
    clicks += other.clicks;
    moved += other.moved;
    asClicked += other.asClicked;
    nearSide += other.nearSide;
    return *this;
}

ClickScore scoreClicks(const sim::Simulation& simulation, int clicks, std::uint64_t seed) {
    ClickScore score;
    const Clicks scene(simulation);
    if (!scene.any()) return score;
    std::optional<Click> last;
    for (int n = 0; n < clicks; ++n) {
        const Click click = scene.click(seed, static_cast<std::uint64_t>(n));
        ++score.clicks;
        score.moved += click.nearSide.moved() ? 1 : 0;
        if (last) {
            scene.measure(*last, click, last->cell, click.cell, score.asClicked);
            scene.measure(*last, click, last->nearSide.cell, click.nearSide.cell, score.nearSide);
        }
        last = click;
    }
    return score;
}

} // namespace edgescan::lab
