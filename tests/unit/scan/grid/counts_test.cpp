// Counts and limits of a scan's cells, compared with simple loops.
#include "core/scan/grid/scan.h"

#include <gtest/gtest.h>

#include <random>

namespace edgescan {
namespace {

TEST(ScanCounts, AreThoseOfAPlainLoop) {
    std::mt19937 random(5);
    for (const int beams : {1, 7, 15, 16, 17, 33, 300}) {
        for (const int share : {0, 1, 50, 100}) {
            Scan scan;
            scan.rangeMm = Grid<float>(5, beams);
            scan.state = Grid<CellState>(5, beams);
            std::array<std::size_t, kCellStates> counts{};
            RangeLimits limits;
            bool any = false;
            for (std::size_t k = 0; k < scan.cells(); ++k) {
                scan.rangeMm[k] = static_cast<float>(random() % 50000);
                scan.state[k] = static_cast<int>(random() % 100) < share ? CellState::Valid : static_cast<CellState>(1 + random() % 5);
                ++counts[static_cast<std::size_t>(scan.state[k])];
                if (scan.state[k] != CellState::Valid) continue;
                limits.minMm = any ? std::min(limits.minMm, scan.rangeMm[k]) : scan.rangeMm[k];
                limits.maxMm = any ? std::max(limits.maxMm, scan.rangeMm[k]) : scan.rangeMm[k];
                any = true;
            }
            EXPECT_EQ(countCells(scan), counts);
            EXPECT_EQ(rangeLimits(scan).minMm, limits.minMm);
            EXPECT_EQ(rangeLimits(scan).maxMm, limits.maxMm);
        }
    }
}

} // namespace
} // namespace edgescan
