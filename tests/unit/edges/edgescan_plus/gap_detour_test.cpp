// Edges around lost ranges, and scans with hardly any ranges.
#include "core/base/order_statistic.h"
#include "core/edges/edgescan_plus/gap_detour.h"
#include "tests/support/depth_edges.h"
#include "tests/support/scans.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <utility>

namespace edgescan::edges {
namespace {

// Moves each response of a filled cell, in order, to the best measured cell without a response: sides before corners.
void goRoundPlainly(const InverseRange& inverse, Grid<float>& response, bool nearest) {
    for (int i = 0; i < response.lines; ++i) {
        for (int j = 0; j < response.beams; ++j) {
            if (inverse.support.at(i, j) != Support::Filled || response.at(i, j) == 0) continue;
            const float value = std::exchange(response.at(i, j), 0.0F);
            float* best = nullptr;
            double least = 1e9;
            for (const bool sides : {true, false}) {
                if (best != nullptr) break;
                for (int n = 0; n < 9; ++n) {
                    const int di = n / 3 - 1;
                    const int dj = n % 3 - 1;
                    if ((di == 0 || dj == 0) != sides || (di == 0 && dj == 0) || !response.contains(i + di, j + dj)) continue;
                    if (inverse.support.at(i + di, j + dj) != Support::Measured || response.at(i + di, j + dj) != 0) continue;
                    const double u = inverse.u.at(i + di, j + dj);
                    const double cost = nearest ? -u : std::abs(u - inverse.u.at(i, j));
                    if (cost >= least) continue;
                    least = cost;
                    best = &response.at(i + di, j + dj);
                }
            }
            if (best != nullptr) *best = value;
        }
    }
}

TEST(GapDetour, GoesRoundAsCellByCell) {
    std::mt19937 random(41);
    std::uniform_real_distribution<float> u(0.1F, 1.0F);
    int moved = 0;
    for (int round = 0; round < 200; ++round) {
        const int lines = 1 + static_cast<int>(random() % 9);
        const int beams = 1 + static_cast<int>(random() % 9);
        InverseRange inverse{Grid<float>(lines, beams), Grid<Support>(lines, beams)};
        Grid<float> jump(lines, beams);
        Grid<float> crease(lines, beams);
        for (std::size_t k = 0; k < jump.size(); ++k) {
            inverse.u[k] = u(random);
            inverse.support[k] = static_cast<Support>(random() % 3);
            const bool any = inverse.support[k] != Support::Void;
            jump[k] = any && random() % 3 == 0 ? u(random) : 0.0F;
            crease[k] = any && random() % 3 == 0 ? u(random) - 0.5F : 0.0F;
        }
        Grid<float> expectedJump = jump;
        Grid<float> expectedCrease = crease;
        goRoundPlainly(inverse, expectedJump, true);
        goRoundPlainly(inverse, expectedCrease, false);
        const Grid<float> before = jump;
        moveJumpsOffGaps(inverse, jump);
        moveFoldsOffGaps(inverse, crease);
        EXPECT_EQ(jump, expectedJump) << round;
        EXPECT_EQ(crease, expectedCrease) << round;
        for (std::size_t k = 0; k < jump.size(); ++k) moved += jump[k] != 0 && before[k] == 0 ? 1 : 0;
    }
    EXPECT_GT(moved, 100);
}

TEST(DepthEdges, RangesThatAreHardlyAnyAreNone) {
    const Scan scan = test::makeScan(30, 30, [](int i, int j) { return (i + j) % 2 == 0 ? 1.0 : 1e-40; });
    const Grid<float> strengths = requestedStrength(test::depthResponses(scan, {}), {});
    for (const float strength : strengths.cells) EXPECT_TRUE(std::isfinite(strength));
    const std::array<float, 4> zeros{-0.0F, 0.0F, 2.0F, 1.0F};
    EXPECT_EQ(nthSmallest(zeros, 1), 0.0F);
    EXPECT_EQ(nthSmallest(zeros, 3), 2.0F);
}

} // namespace
} // namespace edgescan::edges
