// Compares lengths between clicks with lengths between the true points that were meant.
#include "core/lab/clicks/clicks.h"

#include "core/inspect/measure/lengths.h"
#include "core/inspect/measure/near_side.h"
#include "core/sim/random.h"
#include "core/sim/truth/truth.h"

#include <array>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <set>
#include <tuple>

namespace edgescan::lab {
namespace {

constexpr int kAside = 2;          // cells from the edge
constexpr float kJumpMm = 50.0F;   // of the truth
constexpr double kBehindM = 0.030; // an end that is farther than this behind what was meant, and behind a jump, is on another surface

struct Cell {
    int line = 0, beam = 0;
    bool operator==(const Cell&) const = default;
    auto operator<=>(const Cell&) const = default;
};

/// The true surfaces around a click.
class TrueSurfaces {
public:
    explicit TrueSurfaces(const sim::SimulationTruth& truth) : truth_(truth) {}

    [[nodiscard]] bool isHit(Cell at) const { return truth_.object.contains(at.line, at.beam) && truth_.object.at(at.line, at.beam) != 0; }
    [[nodiscard]] double rangeMm(Cell at) const { return static_cast<double>(truth_.cleanMm.at(at.line, at.beam)); }

    /// The nearest cell in front of a true jump; the clicked cell if there is none; empty if no surface is near.
    [[nodiscard]] std::optional<Cell> meant(Cell click) const {
        const std::set<Cell> own = isHit(click) ? surfaceOf(click, click) : std::set<Cell>{};
        std::optional<Cell> best;
        if (isHit(click)) best = click;
        auto least = std::tuple(isHit(click) ? 1000 : 10000, 0.0, Cell{});
        for (int i = click.line - inspect::kSnapReach; i <= click.line + inspect::kSnapReach; ++i) {
            for (int j = click.beam - inspect::kSnapReach; j <= click.beam + inspect::kSnapReach; ++j) {
                const Cell at{i, j};
                const int square = (i - click.line) * (i - click.line) + (j - click.beam) * (j - click.beam);
                if (!isHit(at) || own.contains(at)) continue;
                const auto order = std::tuple(square, rangeMm(at), at);
                if (order < least && (!isHit(click) || isInFront(at, click))) std::tie(least, best) = std::pair(order, std::optional(at));
            }
        }
        // A hole beyond a rim: the cell nearest to it may itself be behind another rim.
        return !isHit(click) && best ? meant(*best, click) : best;
    }

private:
    [[nodiscard]] std::optional<Cell> meant(Cell nearest, Cell click) const {
        const std::optional<Cell> front = meant(nearest);
        const bool isNear =
            front && std::abs(front->line - click.line) <= inspect::kSnapReach && std::abs(front->beam - click.beam) <= inspect::kSnapReach;
        return isNear ? front : nearest;
    }
    [[nodiscard]] bool isLinked(Cell a, Cell b) const {
        if (b < a) std::swap(a, b);
        const Grid<sim::Seam>& seams = a.line == b.line ? truth_.toNextBeam : truth_.toNextLine;
        return isHit(a) && isHit(b) && seams.at(a.line, a.beam).tearMm <= kJumpMm;
    }
    /// A rim whose surface behind is nearer to the click than the rim.
    [[nodiscard]] bool isInFront(Cell rim, Cell click) const {
        for (const auto& [di, dj] : {std::pair{0, 1}, {1, 0}, {0, -1}, {-1, 0}}) {
            const Cell behind{rim.line + di, rim.beam + dj};
            if (!truth_.object.contains(behind.line, behind.beam) || isLinked(rim, behind)) continue;
            if (!isHit(behind) || rangeMm(behind) < rangeMm(rim)) continue;
            if (rangeMm(click) > (rangeMm(rim) + rangeMm(behind)) / 2) return true;
        }
        return false;
    }
    /// Connected without a jump, within a few cells of the click.
    [[nodiscard]] std::set<Cell> surfaceOf(Cell start, Cell click) const {
        constexpr int kRadius = inspect::kSnapReach + 2;
        std::set<Cell> reached{start};
        std::vector<Cell> open{start};
        while (!open.empty()) {
            const Cell at = open.back();
            open.pop_back();
            for (const auto& [di, dj] : {std::pair{0, 1}, {1, 0}, {0, -1}, {-1, 0}}) {
                const Cell next{at.line + di, at.beam + dj};
                if (std::abs(next.line - click.line) > kRadius || std::abs(next.beam - click.beam) > kRadius) continue;
                if (!isHit(next) || !isLinked(at, next) || !reached.insert(next).second) continue;
                open.push_back(next);
            }
        }
        return reached;
    }

    const sim::SimulationTruth& truth_;
};

struct Click {
    std::uint32_t cell = 0;
    std::optional<std::uint32_t> nearSide;
    Eigen::Vector3d meantM;
};

class Clicks {
public:
    explicit Clicks(const sim::Simulation& simulation)
        : scan_(simulation.scan), surfaces_(*simulation.truth), tables_(scan_), noise_(rangeNoise(inverseRange(scan_))) {
        const sim::EdgeTruth truth = sim::edgeTruth(*simulation.truth);
        for (std::size_t k = 0; k < truth.edgeClass.size(); ++k) {
            const auto kind = static_cast<sim::EdgeClass>(truth.edgeClass[k]);
            const bool isRim = kind == sim::EdgeClass::Occluding || kind == sim::EdgeClass::Void;
            if (isRim && truth.ignore[k] == 0) rims_.push_back(static_cast<std::uint32_t>(k));
        }
    }
    [[nodiscard]] bool any() const { return !rims_.empty(); }

    [[nodiscard]] Click click(std::uint64_t seed, std::uint64_t n) const {
        for (std::uint64_t attempt = 0;; ++attempt) {
            const std::uint64_t chance = sim::mixed(sim::mixed(seed) ^ sim::mixed(n * 1000003 + attempt));
            const std::uint32_t rim = rims_[chance % rims_.size()];
            const std::uint64_t aside = sim::mixed(chance);
            constexpr std::uint64_t kSide = 2 * kAside + 1;
            const Cell at{static_cast<int>(rim) / scan_.beams() + static_cast<int>(aside % kSide) - kAside,
                          static_cast<int>(rim) % scan_.beams() + static_cast<int>(aside / kSide % kSide) - kAside};
            if (!scan_.rangeMm.contains(at.line, at.beam)) continue;
            const std::optional<Cell> meant = surfaces_.meant(at);
            if (!meant) continue;
            const auto k = static_cast<std::uint32_t>(scan_.rangeMm.index(at.line, at.beam));
            const inspect::MeantCell cell = inspect::meantCell(scan_, k);
            return {k, cell.measured() ? std::optional(cell.cell) : std::nullopt,
                    tables_.sensor() + surfaces_.rangeMm(*meant) / 1000.0 * tables_.direction(meant->line, meant->beam)};
        }
    }

    void measure(const Click& a, const Click& b, std::optional<std::uint32_t> from, std::optional<std::uint32_t> to,
                 ClickedLengths& lengths) const {
        std::optional<inspect::MeasuredCells> measured;
        if (from && to) measured = inspect::measureCells(scan_, noise_, inspect::MeasureKind::Distance, std::array{*from, *to});
        if (!measured) {
            ++lengths.refused;
            return;
        }
        ++lengths.measured;
        const inspect::MeasuredLength& length = measured->lengths.front();
        const double trueM = (a.meantM - b.meantM).norm();
        const bool isOff =
            length.isBelow ? trueM > length.smallestM + length.toleranceM : std::abs(length.valueM - trueM) > length.toleranceM;
        lengths.off += isOff ? 1 : 0;
        if (!isBehind(a, *from) && !isBehind(b, *to)) return;
        ++lengths.behind;
        lengths.silent += measured->behindM > 0.0 ? 0 : 1;
    }
    [[nodiscard]] const Scan& scan() const { return scan_; }

private:
    [[nodiscard]] bool isBehind(const Click& click, std::uint32_t cell) const {
        const double rangeM = static_cast<double>(scan_.rangeMm[cell]) / 1000.0;
        return rangeM - (click.meantM - tables_.sensor()).norm() >
               kBehindM + 0.01 * rangeM + kSlanted * (tables_.point(cell) - click.meantM).norm();
    }

    static constexpr double kSlanted = 0.5; // of the way between the two points: a slanted surface
    const Scan& scan_;
    TrueSurfaces surfaces_;
    CartesianTables tables_;
    RangeNoise noise_;
    std::vector<std::uint32_t> rims_;
};

} // namespace

ClickedLengths& ClickedLengths::operator+=(const ClickedLengths& other) {
    refused += other.refused;
    measured += other.measured;
    off += other.off;
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
        score.moved += click.nearSide && *click.nearSide != click.cell ? 1 : 0;
        if (last) {
            const auto own = [&](const Click& one) {
                return scene.scan().state[one.cell] == CellState::Valid ? std::optional(one.cell) : std::nullopt;
            };
            scene.measure(*last, click, own(*last), own(click), score.asClicked);
            scene.measure(*last, click, last->nearSide, click.nearSide, score.nearSide);
        }
        last = click;
    }
    return score;
}

} // namespace edgescan::lab
