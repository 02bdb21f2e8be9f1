// Sets of cells compared with slow, simple versions.
#include "core/inspect/measure/cell_sets.h"
#include "core/scan/grid/cartesian.h"
#include "tests/support/scans.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace edgescan::inspect {
namespace {

using Corners = std::vector<Eigen::Vector2d>;

// By the winding of the polygon around the point: odd means inside.
bool isInside(const Corners& corners, double x, double y) {
    bool inside = false;
    for (std::size_t n = 0; n < corners.size(); ++n) {
        const Eigen::Vector2d& a = corners[n];
        const Eigen::Vector2d& b = corners[(n + 1) % corners.size()];
        if ((a.y() > y) != (b.y() > y) && x < (b.x() - a.x()) * (y - a.y()) / (b.y() - a.y()) + a.x()) inside = !inside;
    }
    return inside;
}

TEST(CellSets, APolygonHoldsTheCellsWhoseMiddleLiesInIt) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(-8.0, 38.0);
    for (int round = 0; round < 200; ++round) {
        Corners corners;
        for (int n = 0; n < 3 + round % 9; ++n) corners.emplace_back(place(random), place(random));
        CellSet slow;
        for (std::uint32_t k = 0; k < 20U * 30U; ++k) {
            if (isInside(corners, k % 30U + 0.5, k / 30U + 0.5)) slow.push_back(k);
        }
        EXPECT_EQ(cellsInside(20, 30, corners), slow) << round;
    }
    EXPECT_EQ(cellsInside(20, 30, Corners{{2, 3}, {4, 3}, {4, 4}, {2, 4}}), (CellSet{92, 93})) << "a box on whole cells";
    EXPECT_TRUE(cellsInside(20, 30, Corners{{1, 1}, {5, 5}}).empty());
}

TEST(CellSets, AChainIsWhatHangsTogether) {
    Grid<std::uint8_t> mask(4, 6, 0);
    for (const std::size_t k : {1U, 8U, 15U, 5U, 23U}) mask[k] = 255;
    EXPECT_EQ(chainAt(mask, 8), (CellSet{1, 8, 15}));
    EXPECT_EQ(chainAt(mask, 5), (CellSet{5})) << "the end of one line is no neighbour of the beginning of the next";
    EXPECT_TRUE(chainAt(mask, 0).empty());
    EXPECT_TRUE(chainAt(mask, 24).empty());
}

TEST(CellSets, AddAndTakeAway) {
    const CellSet a{1, 2, 3, 9}, b{2, 4};
    EXPECT_EQ(united(a, b), (CellSet{1, 2, 3, 4, 9}));
    EXPECT_EQ(without(a, b), (CellSet{1, 3, 9}));
    EXPECT_EQ(allBut(a, 6), (CellSet{0, 4, 5}));
    EXPECT_EQ(allBut({}, 2), (CellSet{0, 1}));
}

TEST(CellSets, RunsAreTheSameCells) {
    std::mt19937 random(3);
    for (int round = 0; round < 50; ++round) {
        CellSet set;
        for (std::uint32_t k = 0; k < 300; ++k) {
            if (random() % 3 != 0) set.push_back(k);
        }
        EXPECT_EQ(cellsOf(runsOf(set), 300), set);
    }
    using Runs = std::vector<CellRun>;
    EXPECT_EQ(runsOf({4, 5, 6, 9}), (Runs{{4, 3}, {9, 1}}));
    for (const Runs& wrong : {Runs{{4, 0}}, Runs{{4, 3}, {5, 1}}, Runs{{9, 2}}, Runs{{4294967295U, 2}}, Runs{{2, 4294967295U}}})
        EXPECT_TRUE(cellsOf(wrong, 10).empty());
}

TEST(CellSets, AGateAndABoxHoldBackWhatASlowVersionDoes) {
    Scan scan = test::boxesScan(50, 70, 3, 0.1);
    const CartesianTables tables(scan);
    const CellSet gate = cellsBeyond(scan, 3.0, 5.0);
    CellSet expected;
    for (std::uint32_t k = 0; k < scan.cells(); ++k) {
        if (scan.state[k] == CellState::Valid && (scan.rangeMm[k] < 3000.0F || scan.rangeMm[k] > 5000.0F)) expected.push_back(k);
    }
    EXPECT_EQ(gate, expected);
    EXPECT_FALSE(gate.empty());
    const CellSet corners{800, 805, 1100, 1700, 2303};
    Eigen::Vector3d low = Eigen::Vector3d::Constant(1e9), high = -low;
    for (const std::uint32_t k : corners) {
        if (scan.state[k] != CellState::Valid) continue;
        low = low.cwiseMin(tables.point(k));
        high = high.cwiseMax(tables.point(k));
    }
    const CellSet outside = cellsOutsideBoxOf(scan, corners);
    for (std::uint32_t k = 0; k < scan.cells(); ++k) {
        const Eigen::Vector3d p = tables.point(k);
        const bool out = scan.state[k] == CellState::Valid && !((p.array() >= low.array()).all() && (p.array() <= high.array()).all());
        EXPECT_EQ(std::ranges::binary_search(outside, k), out) << k;
    }
    EXPECT_TRUE(cellsOutsideBoxOf(scan, {}).empty());
}

} // namespace
} // namespace edgescan::inspect
