// Beams modulo the number of phases.
#include "core/files/grid_recovery/phases.h"
#include "core/base/translated_text.h"

#include "core/scan/grid/mean_step.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace edgescan::files::recognition {
namespace {

constexpr int kMostPhases = 8;
constexpr double kNearlyAll = 0.95;
constexpr int kFewestTurns = 3;

/// The phase of each line; -1 where a line has no points, or points of several phases.
std::vector<int> phasesOf(const Grid<std::uint32_t>& pointOf, int phases) {
    std::vector<int> found;
    for (int i = 0; i < pointOf.lines; ++i) {
        std::array<int, kMostPhases> count{};
        int all = 0;
        for (int j = 0; j < pointOf.beams; ++j) {
            if (pointOf.at(i, j) == RecoveredGrid::kNoPoint) continue;
            ++count[static_cast<std::size_t>(j % phases)];
            ++all;
        }
        const auto most = std::max_element(count.begin(), count.end());
        found.push_back(all > 0 && *most >= kNearlyAll * all ? static_cast<int>(most - count.begin()) : -1);
    }
    return found;
}

/// Phase of line i is (first + step * i) % phases.
struct Turns {
    int phases = 1, first = 0, step = 0;
    [[nodiscard]] int phase(int line) const { return (first + step * line) % phases; }
};

Turns turnsIn(const Grid<std::uint32_t>& pointOf) {
    for (int phases = std::min(kMostPhases, pointOf.lines / kFewestTurns); phases > 1; --phases) {
        const std::vector<int> phase = phasesOf(pointOf, phases);
        const auto known = std::count_if(phase.begin(), phase.end(), [](int p) { return p >= 0; });
        if (static_cast<double>(known) < kNearlyAll * pointOf.lines) continue;
        for (int step = 1; step < phases; ++step) {
            if (std::gcd(step, phases) != 1) continue;
            for (int first = 0; first < phases; ++first) {
                const Turns turns{phases, first, step};
                int agreeing = 0;
                for (int i = 0; i < pointOf.lines; ++i) agreeing += phase[static_cast<std::size_t>(i)] == turns.phase(i) ? 1 : 0;
                if (agreeing >= kNearlyAll * pointOf.lines) return turns;
            }
        }
    }
    return {};
}

} // namespace

int foldPhases(RecoveredGrid& grid) {
    const Turns turns = turnsIn(grid.pointOf);
    if (turns.phases == 1) return 1;
    const int rows = (grid.pointOf.lines + turns.phases - 1) / turns.phases;
    const int beams = grid.pointOf.beams;
    const std::vector<double>& lineDeg = grid.geometry.lineDeg;
    const double stepDeg = meanStepDeg(lineDeg);
    std::vector<double> rowDeg;
    std::vector<double> ahead(static_cast<std::size_t>(turns.phases), 0.0); // of its row, by place among the lines of the row
    for (int row = 0; row < rows; ++row) {
        const auto first = static_cast<std::size_t>(row * turns.phases);
        const std::size_t count = std::min(static_cast<std::size_t>(turns.phases), lineDeg.size() - first);
        const double sum = std::accumulate(lineDeg.begin() + static_cast<std::ptrdiff_t>(first),
                                           lineDeg.begin() + static_cast<std::ptrdiff_t>(first + count), 0.0);
        rowDeg.push_back(sum / static_cast<double>(count) +
                         0.5 * stepDeg * static_cast<double>(static_cast<std::size_t>(turns.phases) - count));
        for (std::size_t k = 0; k < ahead.size(); ++k) {
            const double deg =
                k < count ? lineDeg[first + k] : rowDeg.back() + stepDeg * (static_cast<double>(k) - 0.5 * (turns.phases - 1));
            ahead[k] += (deg - rowDeg.back()) / rows;
        }
    }
    Grid<std::uint32_t> pointOf(rows, beams, RecoveredGrid::kNoPoint);
    grid.geometry.lineSkewDeg.assign(static_cast<std::size_t>(beams), 0.0);
    for (int line = 0; line < grid.pointOf.lines; ++line) {
        const int row = line / turns.phases;
        for (int j = 0; j < beams; ++j) {
            const std::uint32_t point = grid.pointOf.at(line, j);
            if (j % turns.phases == turns.phase(line)) {
                pointOf.at(row, j) = point;
                grid.geometry.lineSkewDeg[static_cast<std::size_t>(j)] = ahead[static_cast<std::size_t>(line % turns.phases)];
            } else {
                grid.unplaced += point != RecoveredGrid::kNoPoint ? 1 : 0;
            }
        }
    }
    grid.pointOf = std::move(pointOf);
    grid.geometry.lineDeg = std::move(rowDeg);
    grid.remarks.push_back(withValues("Each line has every %1th beam only, in turn: %2 lines that follow each other were put side by side.",
                                      {turns.phases, turns.phases}));
    return turns.phases;
}

} // namespace edgescan::files::recognition
