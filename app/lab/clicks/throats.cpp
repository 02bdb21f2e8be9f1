// Clicks the two sides of openings again and again, and compares the widths.
#include "app/lab/clicks/throats.h"

#include "app/lab/clicks/clicks.h"
#include "app/lab/sim/random.h"
#include "core/inspect/measure/lengths.h"
#include "core/inspect/measure/near_side.h"
#include "core/inspect/measure/notebook.h"
#include "core/inspect/measure/throat.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace edgescan::lab {
namespace {

constexpr int kMoved = 2;            // cells of a repeated click from the first one
constexpr int kWidest = 80;          // cells across an opening
constexpr int kNarrowest = 5;        // cells
constexpr double kFartherM = 0.3;    // of what is seen through an opening, behind its side
constexpr double kDepthShare = 0.5;  // of the width: the most that the two sides differ in depth
constexpr int kMostAttempts = 1'000; // to find one opening

using TwoClicks = std::array<std::uint32_t, 2>;

class Openings {
public:
    explicit Openings(const sim::Simulation& simulation)
        : scan_(simulation.scan), tables_(scan_), noise_(rangeNoise(inverseRange(scan_))), rims_(nearSides(simulation)) {
        std::erase_if(rims_, [this](std::uint32_t k) { return scan_.state[k] != CellState::Valid; });
    }

    [[nodiscard]] std::optional<TwoClicks> opening(std::uint64_t seed, std::uint64_t n) const {
        for (std::uint64_t attempt = 0; attempt < kMostAttempts && !rims_.empty(); ++attempt) {
            const std::uint64_t chance = sim::mixed(sim::mixed(seed) ^ sim::mixed(n * 1000003 + attempt));
            const std::uint32_t from = rims_[chance % rims_.size()];
            constexpr std::array<std::pair<int, int>, 8> kDirections{
                {{-1, -1}, {-1, 0}, {-1, 1}, {0, -1}, {0, 1}, {1, -1}, {1, 0}, {1, 1}}};
            const auto& [di, dj] = kDirections[sim::mixed(chance) % kDirections.size()];
            if (const auto to = across(from, di, dj)) return TwoClicks{from, *to};
        }
        return std::nullopt;
    }
    /// Up to kMoved cells from the two clicks.
    [[nodiscard]] TwoClicks aside(const TwoClicks& clicks, std::uint64_t chance) const {
        TwoClicks moved = clicks;
        for (std::uint32_t& k : moved) {
            constexpr std::uint64_t kSide = 2 * kMoved + 1;
            const int line = static_cast<int>(k) / scan_.beams(), beam = static_cast<int>(k) % scan_.beams();
            const int i = line + static_cast<int>(chance % kSide) - kMoved, j = beam + static_cast<int>(chance / kSide % kSide) - kMoved;
            if (scan_.rangeMm.contains(i, j)) k = static_cast<std::uint32_t>(scan_.rangeMm.index(i, j));
            chance = sim::mixed(chance);
        }
        return moved;
    }
    [[nodiscard]] std::optional<TwoClicks> endsOfClicks(const TwoClicks& clicks) const {
        const inspect::ClickedCell a = inspect::nearSideCell(scan_, clicks[0]), b = inspect::nearSideCell(scan_, clicks[1]);
        return inspect::narrowestBetween(scan_, tables_, a.cell, b.cell);
    }
    [[nodiscard]] std::optional<TwoClicks> endsAround(const TwoClicks& clicks) const {
        const auto throat = inspect::throatAt(scan_, tables_, clicks[0], clicks[1]);
        return throat ? std::optional(throat->ends) : std::nullopt;
    }
    [[nodiscard]] std::optional<TwoClicks> endsThrough(const TwoClicks& clicks) const {
        const auto throat = inspect::throatThrough(scan_, tables_, between(clicks)[0]);
        return throat ? std::optional(throat->ends) : std::nullopt;
    }
    [[nodiscard]] inspect::MeasuredLength ofClicks(const TwoClicks& ends) const {
        return inspect::measureCells(scan_, noise_, inspect::MeasureKind::Throat, ends)->lengths.front();
    }
    [[nodiscard]] inspect::MeasuredLength ofAround(const TwoClicks& ends, const TwoClicks& clicks) const {
        const inspect::StoredMeasure stored{inspect::MeasureKind::Throat, {ends.begin(), ends.end()}, {clicks.begin(), clicks.end()}};
        return inspect::measureStored(scan_, noise_, stored)->lengths.front();
    }

    /// One click into the opening, halfway between the two.
    [[nodiscard]] TwoClicks between(const TwoClicks& clicks) const {
        const auto [a, b] = clicks;
        const auto beams = static_cast<std::uint32_t>(scan_.beams());
        const std::uint32_t half = (a / beams + b / beams) / 2 * beams + (a % beams + b % beams) / 2;
        return {half, half};
    }

private:
    [[nodiscard]] std::optional<std::uint32_t> across(std::uint32_t from, int di, int dj) const {
        const int line = static_cast<int>(from) / scan_.beams(), beam = static_cast<int>(from) % scan_.beams();
        const double nearM = static_cast<double>(scan_.rangeMm[from]) / 1000.0;
        for (int n = 1; n <= kWidest; ++n) {
            const int i = line + n * di, j = beam + n * dj;
            if (!scan_.rangeMm.contains(i, j)) return std::nullopt;
            const auto k = static_cast<std::uint32_t>(scan_.rangeMm.index(i, j));
            const bool isOpen = scan_.state[k] != CellState::Valid || static_cast<double>(scan_.rangeMm[k]) / 1000.0 > nearM + kFartherM;
            if (isOpen || n == 1) continue; // the cell next to a rim may be a mixed pixel
            if (n < kNarrowest) return std::nullopt;
            const double depthM = std::abs(static_cast<double>(scan_.rangeMm[k]) / 1000.0 - nearM);
            if (depthM > kDepthShare * (tables_.point(k) - tables_.point(from)).norm()) return std::nullopt;
            return k;
        }
        return std::nullopt;
    }

    const Scan& scan_;
    CartesianTables tables_;
    RangeNoise noise_;
    std::vector<std::uint32_t> rims_;
};

/// Adds one opening, which was clicked several times. `endsOf`: of two clicks; `lengthOf`: of two ends and their clicks.
template <class EndsOf, class LengthOf>
void addOpening(const std::vector<TwoClicks>& tries, const EndsOf& endsOf, const LengthOf& lengthOf, ThroatWidths& widths) {
    std::optional<TwoClicks> first;
    double firstM = 0.0, leastM = 0.0, mostM = 0.0;
    bool areEqual = true;
    for (const TwoClicks& clicks : tries) {
        const std::optional<TwoClicks> ends = endsOf(clicks);
        if (!ends) {
            ++widths.refused;
            continue;
        }
        const inspect::MeasuredLength length = lengthOf(*ends, clicks);
        ++widths.measured;
        if (!first) {
            first = ends;
            firstM = leastM = mostM = length.valueM;
        }
        leastM = std::min(leastM, length.valueM);
        mostM = std::max(mostM, length.valueM);
        areEqual = areEqual && *ends == *first;
        widths.off += std::abs(length.valueM - firstM) > length.toleranceM ? 1 : 0;
    }
    if (!first) return;
    widths.equal += areEqual ? 1 : 0;
    widths.spreads.push_back((mostM - leastM) / firstM);
}

} // namespace

ThroatWidths& ThroatWidths::operator+=(const ThroatWidths& other) {
    refused += other.refused;
    measured += other.measured;
    off += other.off;
    equal += other.equal;
    spreads.insert(spreads.end(), other.spreads.begin(), other.spreads.end());
    return *this;
}

ThroatScore& ThroatScore::operator+=(const ThroatScore& other) {
    ofClicks += other.ofClicks;
    ofAround += other.ofAround;
    ofOne += other.ofOne;
    return *this;
}

ThroatScore scoreThroats(const sim::Simulation& simulation, int openings, int repeats, std::uint64_t seed) {
    const Openings scene(simulation);
    ThroatScore score;
    for (int n = 0; n < openings; ++n) {
        const auto opening = scene.opening(seed, static_cast<std::uint64_t>(n));
        if (!opening) continue;
        std::vector<TwoClicks> tries{*opening};
        for (int again = 0; again < repeats; ++again)
            tries.push_back(scene.aside(*opening, sim::mixed(sim::mixed(seed) ^ sim::mixed(static_cast<std::uint64_t>(n * 131 + again)))));
        addOpening(
            tries, [&](const TwoClicks& clicks) { return scene.endsOfClicks(clicks); },
            [&](const TwoClicks& ends, const TwoClicks&) { return scene.ofClicks(ends); }, score.ofClicks);
        addOpening(
            tries, [&](const TwoClicks& clicks) { return scene.endsAround(clicks); },
            [&](const TwoClicks& ends, const TwoClicks& clicks) { return scene.ofAround(ends, clicks); }, score.ofAround);
        addOpening(
            tries, [&](const TwoClicks& clicks) { return scene.endsThrough(clicks); },
            [&](const TwoClicks& ends, const TwoClicks& clicks) { return scene.ofAround(ends, scene.between(clicks)); }, score.ofOne);
    }
    return score;
}

} // namespace edgescan::lab
