// Watershed of the distance to edges, and PCL's segments in their cells.
#include "app/lab/peers/watershed_rocks.h"

#include "app/lab/peers/peers.h"
#include "core/scan/grid/scan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace edgescan::lab {
namespace {

TEST(WatershedRocks, AFrameOfEdgesPartsItsInsideFromItsOutside) {
    Grid<std::uint8_t> edges(40, 60);
    Grid<std::uint8_t> solid(40, 60, std::uint8_t{1});
    for (int n = 10; n <= 30; ++n) edges.at(10, n + 5) = edges.at(30, n + 5) = edges.at(n, 15) = edges.at(n, 35) = 255;
    solid.at(0, 59) = 0;
    const Grid<std::uint32_t> piece = watershedRocks(edges, solid);
    EXPECT_EQ(piece.at(0, 59), 0U);
    EXPECT_NE(piece.at(20, 25), piece.at(3, 50));
    for (int i = 12; i < 29; ++i)
        for (int j = 17; j < 34; ++j) EXPECT_EQ(piece.at(i, j), piece.at(20, 25)) << i << " " << j;
    // A gap of a quarter of one side does not open the frame, and without edges everything is one piece.
    for (int n = 18; n < 23; ++n) edges.at(n, 35) = 0;
    const Grid<std::uint32_t> gap = watershedRocks(edges, solid);
    EXPECT_NE(gap.at(20, 25), gap.at(20, 50));
    const Grid<std::uint32_t> none = watershedRocks(Grid<std::uint8_t>(40, 60), solid);
    for (std::size_t k = 0; k < none.size(); ++k) EXPECT_EQ(none[k], solid[k] == 0 ? 0U : 1U);
}

// A wall 5 m away, and a box 1.5 m in front of it.
TEST(RockPeers, SegmentsKeepABoxApartFromTheWall) {
    if (const Result<Done> present = checkPclIsAvailable(); !present) GTEST_SKIP() << present.error().sentence();
    Scan scan;
    PolarGeometry polar;
    polar.axis = Axis::Sweep;
    for (int i = 0; i < 120; ++i) polar.lineDeg.push_back(0.25 * (i - 60));
    for (int j = 0; j < 120; ++j) polar.beamDeg.push_back(90.0 + 0.25 * (j - 60));
    scan.geometry = polar;
    scan.rangeMm = {120, 120};
    scan.state = {120, 120, CellState::Valid};
    const auto isBox = [](int i, int j) { return i >= 40 && i < 80 && j >= 40 && j < 80; };
    for (int i = 0; i < 120; ++i)
        for (int j = 0; j < 120; ++j) scan.rangeMm.at(i, j) = isBox(i, j) ? 3500.0F : 5000.0F;
    scan.state.at(60, 60) = CellState::NoReturn;
    for (const PclMethod peer : {PclMethod::RegionGrowing, PclMethod::ConvexPatches}) {
        const Result<PclEdges> answer = runPclMethod(peer, pclScan(scan), {});
        ASSERT_TRUE(answer) << answer.error().sentence();
        const Grid<std::uint32_t>& segments = answer->segments;
        ASSERT_EQ(segments.size(), scan.cells()) << pclMethodName(peer);
        EXPECT_EQ(segments.at(60, 60), 0U) << "no range, no segment";
        std::map<std::uint32_t, std::size_t> inBox, inWall;
        for (int i = 0; i < 120; ++i)
            for (int j = 0; j < 120; ++j) ++(isBox(i, j) ? inBox : inWall)[segments.at(i, j)];
        for (const auto& [segment, cells] : inBox) {
            if (segment != 0) {
                EXPECT_EQ(inWall.count(segment), 0U) << pclMethodName(peer) << " joins what is 1.5 m apart";
            }
        }
        std::size_t most = 0;
        for (const auto& [segment, cells] : inBox) most = std::max(most, segment == 0 ? 0 : cells);
        EXPECT_GT(most, 1000U) << pclMethodName(peer) << ": most of a flat side is one segment";
    }
}

} // namespace
} // namespace edgescan::lab
