// Every n-th line and beam: the same points, bit by bit.
#include "core/scan/grid/every_nth.h"

#include "core/scan/grid/cartesian.h"
#include "core/scan/grid/placement.h"
#include "tests/support/point_lists.h"

#include <gtest/gtest.h>

using namespace edgescan;
using namespace edgescan::test;

namespace {

void expectSamePoints(const Scan& some, const Scan& all, int n) {
    ASSERT_EQ(some.lines(), (all.lines() + n - 1) / n);
    ASSERT_EQ(some.beams(), (all.beams() + n - 1) / n);
    const CartesianTables tables(some), whole(all);
    for (int i = 0; i < some.lines(); ++i) {
        for (int j = 0; j < some.beams(); ++j) {
            EXPECT_EQ(some.state.at(i, j), all.state.at(n * i, n * j));
            EXPECT_EQ(some.rangeMm.at(i, j), all.rangeMm.at(n * i, n * j));
            if (some.state.at(i, j) != CellState::Valid) continue;
            EXPECT_EQ(tables.point(i, j), whole.point(n * i, n * j));
        }
    }
}

} // namespace

TEST(EveryNth, HasTheCellsOfTheScan) {
    for (const int beams : {1, 2, 30, 31, 32}) {
        Scan scan = makeScan({.lines = 10, .beams = beams, .seed = 3});
        for (std::size_t k = 0; k < scan.cells(); k += 5) scan.state[k] = static_cast<CellState>(k % 3);
        auto& polar = std::get<PolarGeometry>(scan.geometry);
        for (int j = 0; j < beams; ++j) polar.lineSkewDeg.push_back(0.01 * j);
        for (const int n : {1, 3, 4}) expectSamePoints(everyNth(scan, n), scan, n);
    }
}

TEST(EveryNth, HasThePointsAndIntensitiesOfACloud) {
    Scan scan = makeScan({.lines = 7, .beams = 20, .seed = 4});
    PointGeometry given;
    given.pointsM = Grid<Eigen::Vector3d>(7, 20, Eigen::Vector3d::Zero());
    for (std::size_t k = 0; k < scan.cells(); ++k) given.pointsM[k] = {0.1 * static_cast<double>(k), 1e6 / 3, -static_cast<double>(k)};
    given.sensorM = {1, 2, 3};
    scan.geometry = given;
    scan.intensity = Grid<float>(7, 20, 5.0F);
    const Scan some = everyNth(scan, 3);
    expectSamePoints(some, scan, 3);
    EXPECT_EQ(std::get<PointGeometry>(some.geometry).sensorM, given.sensorM);
    EXPECT_EQ(some.intensity, Grid<float>(3, 7, 5.0F));
}

TEST(EveryNth, HasThePosesOfItsLines) {
    Scan scan = makeScan({.lines = 7, .beams = 20, .seed = 5});
    Placement placement;
    placement.poses.resize(7);
    for (int i = 0; i < 7; ++i) placement.poses[static_cast<std::size_t>(i)].translationM.x() = i;
    scan.placement = std::make_shared<const Placement>(placement);
    const Scan some = everyNth(scan, 3);
    ASSERT_EQ(some.placement->poses.size(), 3U);
    for (int i = 0; i < 3; ++i) EXPECT_EQ(some.placement->poses[static_cast<std::size_t>(i)].translationM.x(), 3.0 * i);
}
