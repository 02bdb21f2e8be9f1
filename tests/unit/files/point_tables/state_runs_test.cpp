// Runs of states in a description, compared with a check of every cell.
#include "core/files/point_tables/description.h"
#include "core/scan/grid/scan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <tuple>
#include <vector>

namespace edgescan::files {
namespace {

using FoundRun = std::tuple<CellState, std::size_t, std::size_t>;

std::vector<FoundRun> runsCellByCell(const std::vector<CellState>& states) {
    std::vector<FoundRun> runs;
    for (std::size_t k = 0; k < states.size(); ++k) {
        const CellState state = states[k];
        if (state == CellState::Valid || state == CellState::NoReturn || state == CellState::DeviceStatus) continue;
        if (k > 0 && states[k - 1] == state)
            ++std::get<2>(runs.back());
        else
            runs.emplace_back(state, k, 1);
    }
    return runs;
}

TEST(StateRuns, AreThoseOfALookAtEveryCell) {
    std::mt19937 random(3);
    for (const int cells : {0, 1, 255, 256, 257, 511, 512, 513, 5000}) {
        for (int turn = 0; turn < 40; ++turn) {
            Scan scan;
            scan.state = Grid<CellState>(1, cells, CellState::Valid);
            scan.rangeMm = Grid<float>(1, cells);
            for (int n = static_cast<int>(random() % 6); n > 0 && cells > 0; --n) { // runs with random begin and end
                const std::size_t first = random() % static_cast<unsigned>(cells);
                const std::size_t end = std::min<std::size_t>(first + 1 + random() % 700, static_cast<std::size_t>(cells));
                std::fill(scan.state.cells.begin() + static_cast<std::ptrdiff_t>(first),
                          scan.state.cells.begin() + static_cast<std::ptrdiff_t>(end), static_cast<CellState>(random() % kCellStates));
            }
            std::vector<FoundRun> found;
            for (const StateRun& run : stateRunsOf(scan)) found.emplace_back(run.state, run.firstCell, run.cells);
            EXPECT_EQ(found, runsCellByCell(scan.state.cells)) << cells << " cells, turn " << turn;
        }
    }
}

} // namespace
} // namespace edgescan::files
