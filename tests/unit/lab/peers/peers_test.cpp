// The PCL methods find the edges of a box in front of a wall, each in the right cells.
#include "app/lab/peers/peers.h"
#include "tests/support/scans.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace edgescan::lab {
namespace {

// A box 1 m in front of a wall at 5 m: lines 30..59, beams 40..79.
Scan boxBeforeWall() {
    const PolarGeometry polar = test::regularAngles(90, 120);
    std::mt19937 random(3);
    std::normal_distribution<double> noise(0.0, 3.0);
    return test::makeScan(90, 120, [&](int i, int j) {
        const bool box = i >= 30 && i < 60 && j >= 40 && j < 80;
        return test::wallRangeMm(polar, i, j, box ? 4000.0 : 5000.0) + std::round(noise(random));
    });
}

// Share of the box's outline cells with an edge at most `reach` cells away.
double outlineFound(const Grid<std::uint8_t>& mask, int reach) {
    int found = 0;
    int all = 0;
    for (int i = 30; i < 60; ++i) {
        for (int j = 40; j < 80; ++j) {
            if (i != 30 && i != 59 && j != 40 && j != 79) continue;
            ++all;
            bool near = false;
            for (int a = i - reach; a <= i + reach; ++a) {
                for (int b = j - reach; b <= j + reach; ++b) near = near || mask.at(a, b) != 0;
            }
            found += near ? 1 : 0;
        }
    }
    return static_cast<double>(found) / all;
}

// Edge cells at the height of the box between two beams, including both.
int cellsOn(const Grid<std::uint8_t>& mask, int firstBeam, int lastBeam) {
    int count = 0;
    for (int i = 33; i < 57; ++i) {
        for (int j = firstBeam; j <= lastBeam; ++j) count += mask.at(i, j) != 0 ? 1 : 0;
    }
    return count;
}

class Peers : public testing::Test {
protected:
    void SetUp() override {
        if (const Result<Done> present = checkPclIsAvailable(); !present) GTEST_SKIP() << present.error().sentence();
    }
};

TEST_F(Peers, EachFindsTheOutlineOfABoxInItsCells) {
    const Scan scan = boxBeforeWall();
    const PclScan seen = pclScan(scan);
    PclLimits limits;
    limits.seconds = std::numeric_limits<double>::infinity();
    limits.radiusM = 0.06;
    for (int n = 0; n < kPclEdgeMethods; ++n) {
        const PclMethod peer = static_cast<PclMethod>(n);
        const Result<PclEdges> edges = runPclMethod(peer, seen, limits);
        ASSERT_TRUE(edges) << edges.error().sentence();
        ASSERT_EQ(edges->mask.size(), scan.cells());
        EXPECT_EQ(edges->share, 1.0);
        EXPECT_GT(outlineFound(edges->mask, 2), 0.9) << pclMethodName(peer);
        // The middle of the box is flat.
        int inside = 0;
        for (int i = 38; i < 52; ++i) {
            for (int j = 48; j < 72; ++j) inside += edges->mask.at(i, j) != 0 ? 1 : 0;
        }
        EXPECT_LT(inside, 14 * 24 / 10) << pclMethodName(peer);
        EXPECT_FALSE(edges->steps.empty());
    }
}

TEST_F(Peers, BordersAreDistinguished) {
    const PclScan seen = pclScan(boxBeforeWall());
    const Result<PclEdges> borders = runPclMethod(PclMethod::RangeImageBorder, seen, {});
    ASSERT_TRUE(borders);
    ASSERT_EQ(borders->classes.size(), 3U);
    // The object border is on the box, the shadow border on the wall next to it.
    EXPECT_GT(cellsOn(borders->classes[0].mask, 40, 42), 15);
    EXPECT_EQ(cellsOn(borders->classes[0].mask, 37, 39), 0);
    EXPECT_GT(cellsOn(borders->classes[1].mask, 37, 39), 15);
    EXPECT_EQ(cellsOn(borders->classes[1].mask, 40, 42), 0);
    const Result<PclEdges> organised = runPclMethod(PclMethod::OrganizedEdge, seen, {});
    ASSERT_TRUE(organised);
    EXPECT_GT(cellsOn(organised->classes[0].mask, 40, 42), 15); // occluding
    EXPECT_GT(cellsOn(organised->classes[1].mask, 37, 39), 15); // occluded
}

TEST_F(Peers, ASlowOneStopsWhenItsTimeIsUp) {
    PclLimits limits;
    limits.seconds = 0.0;
    const Result<PclEdges> edges = runPclMethod(PclMethod::BoundaryNeighbours, pclScan(boxBeforeWall()), limits);
    ASSERT_TRUE(edges);
    EXPECT_GT(edges->share, 0.0);
    EXPECT_LT(edges->share, 0.5);
}

TEST_F(Peers, TooLittleIsRefusedInOneSentence) {
    const PclScan nothing = pclScan(test::makeScan(20, 20, [](int, int) { return 0.0F; }));
    for (int n = 0; n < kPclEdgeMethods; ++n) EXPECT_FALSE(runPclMethod(static_cast<PclMethod>(n), nothing, {}));
}

// PCL's normals crashed on grids of 8 and 9 lines: every grid gives edges or one sentence, and never a crash.
TEST_F(Peers, SmallGridsGiveEdgesOrASentence) {
    for (const auto& [lines, beams] : {std::pair{8, 60}, {9, 60}, {10, 60}, {60, 9}, {7, 200}}) {
        const PolarGeometry polar = test::regularAngles(lines, beams);
        const PclScan seen = pclScan(test::makeScan(lines, beams, [&](int i, int j) { return test::wallRangeMm(polar, i, j, 5000.0); }));
        for (int n = 0; n < kPclEdgeMethods; ++n) {
            const Result<PclEdges> edges = runPclMethod(static_cast<PclMethod>(n), seen, {});
            if (edges)
                EXPECT_EQ(edges->mask.size(), seen.pointsM.size());
            else
                EXPECT_EQ(edges.error().sentence().find("crashed"), std::string::npos)
                    << lines << " x " << beams << ": " << edges.error().sentence();
        }
    }
}

TEST_F(Peers, OneThatRunsOutOfMemoryIsReported) {
    PclLimits limits;
    limits.memoryBytes = 300U << 20U; // enough for PCL's libraries, not for the scan
    const PclScan large = pclScan(test::makeScan(1000, 1000, [](int, int) { return 5000.0F; }));
    const Result<PclEdges> edges = runPclMethod(PclMethod::RangeImageBorder, large, limits);
    ASSERT_FALSE(edges);
    EXPECT_NE(edges.error().sentence().find("needed more than 314.6 MB of memory"), std::string::npos) << edges.error().sentence();
}

TEST_F(Peers, OneThatCrashesIsReported) {
    PclScan broken = pclScan(boxBeforeWall());
    // the guard checks pointsM; PCL computes "1 - 10" in an unsigned type
    broken.unrolledM = Grid<Eigen::Vector3f>(1, 1, Eigen::Vector3f::Zero());
    const Result<PclEdges> edges = runPclMethod(PclMethod::OrganizedEdgeUnrolled, broken, {});
    ASSERT_FALSE(edges);
    EXPECT_NE(edges.error().sentence().find("PCL crashed"), std::string::npos) << edges.error().sentence();
}

} // namespace
} // namespace edgescan::lab
