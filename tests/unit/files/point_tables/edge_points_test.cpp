// The points of edges: few of a line are made one by one, many with the whole line; both are the points of their cells, bit by bit.
#include "core/files/point_tables/cell_runs.h"
#include "core/files/point_tables/cloud_columns.h"
#include "core/scan/grid/cartesian.h"
#include "tests/support/point_lists.h"

#include <gtest/gtest.h>

using namespace edgescan;
using namespace edgescan::files;
using namespace edgescan::test;

TEST(EdgePoints, AreThePointsOfTheirCells) {
    for (const Axis axis : {Axis::Spin, Axis::Sweep}) {
        Scan scan = makeScan({.axis = axis, .lines = 9, .beams = 61, .seed = 3});
        for (std::size_t k = 0; k < scan.cells(); k += 7) scan.state[k] = CellState::NoReturn;
        Grid<std::uint8_t> mask(scan.lines(), scan.beams());
        // Of line 0 no cell, of line 1 every one, of line 2 every second one ...
        for (int i = 1; i < scan.lines(); ++i) {
            for (int j = 0; j < scan.beams(); j += i) mask.at(i, j) = 255;
        }
        const CloudColumns cloud = edgePoints(scan, mask);
        const auto cells = cellsOfRuns(cellRunsText(scan, &mask, false), cloud.width, scan.cells());
        ASSERT_TRUE(cells && !cells->empty());
        std::size_t row = 0;
        const CartesianTables tables(scan);
        for (std::uint32_t k = 0; k < scan.cells(); ++k) {
            if (mask[k] == 0 || scan.state[k] != CellState::Valid) continue;
            ASSERT_EQ((*cells)[row], k);
            for (std::size_t at = 0; at < 3; ++at)
                ASSERT_EQ(std::get<std::vector<float>>(cloud.columns[at].values)[row],
                          static_cast<float>(tables.point(k)[static_cast<Eigen::Index>(at)]));
            ++row;
        }
        EXPECT_EQ(row, cloud.width);
    }
}
