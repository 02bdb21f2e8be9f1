// Compares straight lines in inverse range on both sides of a gap.
#include "core/inspect/measure/jumps_along.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace edgescan::inspect {
namespace {

constexpr double kLeastM = 0.030;   // at the scanner; that of EdgeScan+ for an LMS511
constexpr double kGrowth = 0.010;   // of the range
constexpr double kGrazing = 0.10;   // of the slope of a slanted surface, per cell
constexpr int kMixedCells = 2;      // at most, between two surfaces
constexpr double kMixedApart = 2.0; // limits: two surfaces with mixed pixels between them are this far apart
constexpr double kLeastU = 1e-3;    // 1/m: a continued surface is at most this far

class Row {
public:
    explicit Row(std::span<const double> rangesM) : rangesM_(rangesM) {}

    [[nodiscard]] int size() const { return static_cast<int>(rangesM_.size()); }
    [[nodiscard]] double range(int n) const { return n >= 0 && n < size() ? rangesM_[static_cast<std::size_t>(n)] : 0.0; }
    [[nodiscard]] bool has(int n) const { return range(n) > 0.0; }

    /// The step from one surface to the other; 0: there is no jump.
    [[nodiscard]] double stepBetween(int a, int b, double ofLimit) const {
        const auto before = slope(a, -1), behind = slope(b, 1);
        const bool anyBetween = isAnyBetween(a, b);
        if (anyBetween && (!before || !behind)) return 0.0; // a single cell does not say how its surface goes on
        const double slopeA = before.value_or(behind.value_or(0.0)), slopeB = behind.value_or(before.value_or(0.0));
        const auto lineA = [&](int n) { return 1.0 / std::max(kLeastU, 1.0 / range(a) + slopeA * (n - a)); };
        const auto lineB = [&](int n) { return 1.0 / std::max(kLeastU, 1.0 / range(b) + slopeB * (n - b)); };
        const double atA = lineB(a) - range(a), atB = range(b) - lineA(b);
        if (atA * atB <= 0.0) return 0.0; // the lines meet between the cells: a fold, not a jump
        const double step = std::abs(atA) < std::abs(atB) ? atA : atB;
        const double slant = (b - a) * std::max(std::abs(slopeA) * range(a) * range(a), std::abs(slopeB) * range(b) * range(b));
        const double limit = ofLimit * (leastJumpM(std::min(range(a), range(b))) + kGrazing * slant);
        if (std::abs(step) <= limit) return 0.0;
        for (int n = a + 1; anyBetween && n < b; ++n) {
            if (!has(n)) continue;
            const double toA = std::abs(range(n) - lineA(n)), toB = std::abs(range(n) - lineB(n)), apart = std::abs(lineA(n) - lineB(n));
            if (apart < kMixedApart * limit || std::max(toA, toB) > apart) return 0.0;
        }
        return step;
    }

private:
    [[nodiscard]] bool isAnyBetween(int a, int b) const {
        for (int n = a + 1; n < b; ++n) {
            if (has(n)) return true;
        }
        return false;
    }
    /// Of the inverse range per cell, from the cells beyond `n`. Of two steps the flatter one, because the other may reach another surface.
    [[nodiscard]] std::optional<double> slope(int n, int away) const {
        if (!has(n + away)) return std::nullopt;
        const double first = away * (1.0 / range(n + away) - 1.0 / range(n));
        if (!has(n + 2 * away)) return first;
        const double second = away * (1.0 / range(n + 2 * away) - 1.0 / range(n + away));
        if (first * second <= 0.0) return 0.0;
        return std::abs(first) < std::abs(second) ? first : second;
    }

    std::span<const double> rangesM_;
};

} // namespace

double leastJumpM(double rangeM) { return kLeastM + kGrowth * rangeM; }

std::vector<RowJump> jumpsAlong(std::span<const double> rangesM, int widestGap, double ofLimit) {
    const Row row(rangesM);
    std::vector<RowJump> jumps;
    for (int a = 0; a < row.size(); ++a) {
        if (!row.has(a)) continue;
        int between = 0; // cells with a range
        for (int b = a + 1; b < row.size() && between <= kMixedCells && b - a - 1 - between <= widestGap; ++b) {
            if (!row.has(b)) continue;
            if (const double step = row.stepBetween(a, b, ofLimit); step != 0.0) {
                jumps.push_back({a, b, step});
                break;
            }
            ++between;
        }
    }
    // What contains a shorter jump is not one: its own cells are between.
    const auto containsAnother = [&](const RowJump& jump) {
        return std::ranges::any_of(jumps, [&](const RowJump& other) {
            return other.from >= jump.from && other.to <= jump.to && other.to - other.from < jump.to - jump.from;
        });
    };
    std::vector<RowJump> shortest;
    std::ranges::copy_if(jumps, std::back_inserter(shortest), [&](const RowJump& jump) { return !containsAnother(jump); });
    // A single cell between two jumps of one direction is a mixed pixel: both are one jump.
    std::vector<RowJump> joined;
    for (const RowJump& jump : shortest) {
        const bool goesOn = !joined.empty() && joined.back().to == jump.from && joined.back().stepM * jump.stepM > 0.0;
        if (goesOn && jump.to - joined.back().from <= kMixedCells + 1) {
            joined.back().to = jump.to;
            joined.back().stepM += jump.stepM;
        } else {
            joined.push_back(jump);
        }
    }
    return joined;
}

CellsAround cellsAround(const Scan& scan, int line, int beam, int lineStep, int beamStep) {
    CellsAround around;
    for (int n = 0; n < static_cast<int>(around.rangesM.size()); ++n) {
        const int i = line + (n - CellsAround::kReach) * lineStep, j = beam + (n - CellsAround::kReach) * beamStep;
        if (scan.rangeMm.contains(i, j) && scan.state.at(i, j) == CellState::Valid)
            around.rangesM[static_cast<std::size_t>(n)] = static_cast<double>(scan.rangeMm.at(i, j)) / 1000.0;
    }
    return around;
}

bool isOneSurface(const Scan& scan, int line, int beam, int lineStep, int beamStep) {
    constexpr int kHere = CellsAround::kReach;
    const CellsAround around = cellsAround(scan, line, beam, lineStep, beamStep);
    if (!(around.rangesM[kHere] > 0.0) || !(around.rangesM[kHere + 1] > 0.0)) return false;
    const auto jumps = jumpsAlong(around.rangesM, 0);
    return std::ranges::none_of(jumps, [](const RowJump& jump) { return jump.from <= kHere && jump.to > kHere; });
}

} // namespace edgescan::inspect
