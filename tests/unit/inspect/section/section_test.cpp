// Sections: compared with every pair of neighbours, and with lengths of known scenes.
#include "core/edges/pipeline/pipeline.h"
#include "core/inspect/measure/jumps_along.h"
#include "core/inspect/section/section.h"
#include "core/scan/grid/cartesian.h"
#include "tests/support/scans.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <random>
#include <variant>

namespace edgescan::inspect {
namespace {

std::shared_ptr<const edges::Detection> detected(Scan scan) {
    return edges::detectEdges(std::make_shared<const Scan>(std::move(scan)), edges::Settings{});
}

/// Every pair of neighbours on one surface between which the plane passes: a slow count of the vertices on beams and lines.
std::size_t crossings(const Scan& scan, const SectionPlane& plane) {
    const CartesianTables tables(scan);
    const Eigen::Vector3d normal = plane.across.cross(plane.up);
    const auto side = [&](int i, int j) { return (tables.point(i, j) - plane.originM).dot(normal) > 0; };
    std::size_t count = 0;
    for (int i = 0; i < scan.lines(); ++i) {
        for (int j = 0; j < scan.beams(); ++j) {
            for (const auto& [di, dj] : {std::pair{0, 1}, {1, 0}}) {
                if (!scan.rangeMm.contains(i + di, j + dj) || !isOneSurface(scan, i, j, di, dj)) continue;
                count += side(i, j) != side(i + di, j + dj) ? 1 : 0;
            }
        }
    }
    return count;
}

TEST(Section, OfAWallIsOneStraightLineOfItsLength) {
    const PolarGeometry polar = test::regularAngles(80, 80);
    const auto detection = detected(test::makeScan(80, 80, [&](int i, int j) { return test::wallRangeMm(polar, i, j, 5000); }));
    const Scan& scan = *detection->scan;
    const auto from = static_cast<std::uint32_t>(scan.rangeMm.index(20, 20)), to = static_cast<std::uint32_t>(scan.rangeMm.index(60, 60));
    const auto plane = planeThrough(scan, from, to);
    ASSERT_TRUE(plane) << plane.error().sentence();
    EXPECT_TRUE(plane->upAssumed);
    EXPECT_NEAR(plane->across.dot(plane->up), 0.0, 1e-12);
    EXPECT_NEAR(plane->across.norm(), 1.0, 1e-12);
    const Section section = sectionOf(*detection, *plane);
    ASSERT_EQ(section.lines.size(), 1U);
    const CartesianTables tables(scan);
    // The end of the click is at its distance, and each vertex is on the plane and within a rounded millimetre of the wall.
    const Eigen::Vector3d way = tables.point(to) - tables.point(from);
    EXPECT_NEAR((Eigen::Vector2d(way.dot(plane->across), way.dot(plane->up)).norm()), way.norm(), 1e-9) << "both clicks are in the plane";
    const double wallM = tables.point(from).z();
    for (const SectionVertex& vertex : section.lines[0]) {
        EXPECT_NEAR((vertex.pointM - plane->originM).dot(plane->across.cross(plane->up)), 0.0, 1e-9);
        EXPECT_NEAR(vertex.pointM.z(), wallM, 0.003);
        const Eigen::Vector3d again = plane->originM + vertex.atM.x() * plane->across + vertex.atM.y() * plane->up;
        EXPECT_NEAR((again - vertex.pointM).norm(), 0.0, 1e-9);
    }
    const MeasuredLength length = sectionLength(scan, {5.5, 0.25}, section.lines[0].front(), section.lines[0].back());
    EXPECT_NEAR(length.valueM, (section.lines[0].front().atM - section.lines[0].back().atM).norm(), 1e-9);
    EXPECT_GT(length.toleranceM, 0.0);
    // As a stored measurement it is the same length.
    const SectionVertex &a = section.lines[0].front(), &b = section.lines[0].back();
    const std::vector<std::uint32_t> cells{a.cell, a.other, b.cell, b.other};
    const auto stored = measureCells(scan, {5.5, 0.25}, MeasureKind::Section, cells, std::array{a.share, b.share});
    ASSERT_TRUE(stored);
    EXPECT_NEAR(stored->lengths.at(0).valueM, length.valueM, 1e-9);
    EXPECT_NEAR(stored->lengths.at(0).toleranceM, length.toleranceM, 1e-9);
    EXPECT_EQ(measureText(*stored), lengthText(length));
    EXPECT_FALSE(measureCells(scan, {5.5, 0.25}, MeasureKind::Section, cells)) << "without shares";
}

TEST(Section, HasAVertexWhereverThePlanePassesBetweenNeighbours) {
    for (std::uint32_t seed = 1; seed <= 12; ++seed) {
        const auto detection = detected(test::boxesScan(60, 70, seed, 0.01));
        const Scan& scan = *detection->scan;
        std::mt19937 random(seed);
        std::uint32_t from = 0, to = 0;
        const auto chance = [&] { return static_cast<std::uint32_t>(random() % scan.cells()); };
        do from = chance();
        while (scan.state[from] != CellState::Valid);
        do to = chance();
        while (scan.state[to] != CellState::Valid || to == from);
        const auto plane = planeThrough(scan, from, to);
        if (!plane) continue;
        const Section section = sectionOf(*detection, *plane);
        std::size_t vertices = 0;
        const CartesianTables tables(scan);
        for (const SectionLine& line : section.lines) {
            EXPECT_GE(line.size(), 2U);
            for (std::size_t n = 0; n < line.size(); ++n) {
                EXPECT_NEAR((line[n].pointM - plane->originM).dot(plane->across.cross(plane->up)), 0.0, 1e-6);
                EXPECT_EQ(scan.state[line[n].cell], CellState::Valid);
                // Nothing is drawn across a jump: neighbours along the line are as near as neighbours of one surface.
                if (n > 0) {
                    const double range = tables.point(line[n].cell).norm();
                    EXPECT_LT((line[n].pointM - line[n - 1].pointM).norm(), leastJumpM(range) * 3 + 0.05) << "seed " << seed;
                }
            }
            vertices += line.size();
        }
        // Diagonals add vertices; sides without a whole triangle have none.
        EXPECT_GE(2 * vertices + 20, crossings(scan, *plane)) << "seed " << seed;
    }
}

TEST(Section, MarksEdgesAndRocks) {
    const auto detection =
        detected(test::makeScan(60, 60, [](int i, int j) { return i > 20 && i < 40 && j > 20 && j < 40 ? 4000.0 : 6000.0; }));
    const Scan& scan = *detection->scan;
    Grid<std::uint32_t> rockOf(60, 60);
    for (int i = 21; i < 40; ++i) {
        for (int j = 21; j < 40; ++j) rockOf.at(i, j) = 7;
    }
    const auto cell = [&](int i, int j) { return static_cast<std::uint32_t>(scan.rangeMm.index(i, j)); };
    const auto plane = planeThrough(scan, cell(30, 5), cell(30, 30));
    ASSERT_TRUE(plane) << plane.error().sentence();
    const Section section = sectionOf(*detection, *plane, &rockOf);
    std::size_t edges = 0, rocks = 0, others = 0;
    for (const SectionLine& line : section.lines) {
        for (const SectionVertex& vertex : line) {
            edges += vertex.edge ? 1 : 0;
            (vertex.rock == 7 ? rocks : others) += 1;
        }
    }
    EXPECT_GE(section.lines.size(), 2U);
    EXPECT_GT(edges, 0U);
    EXPECT_GT(rocks, 5U);
    EXPECT_GT(others, 5U);
}

TEST(Section, APlaneThatIsNoPlaneIsRefused) {
    const Scan scan = test::makeScan(20, 20, [](int i, int) { return i == 0 ? 0.0 : 5000.0; });
    EXPECT_FALSE(planeThrough(scan, 0, 100));
    EXPECT_FALSE(planeThrough(scan, 100, 100));
    EXPECT_FALSE(planeThrough(scan, 100, 100000));
    EXPECT_FALSE(planeThroughRock(scan, {1, 2}));
    const auto refused = planeThroughRock(scan, {});
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().sentence().find("no section"), std::string::npos);
    std::vector<std::uint32_t> rock;
    for (std::uint32_t k = 105; k < 115; ++k) rock.push_back(k);
    const auto plane = planeThroughRock(scan, rock);
    ASSERT_TRUE(plane);
    EXPECT_NEAR(plane->across.dot(plane->up), 0.0, 1e-12);
    // Left and right as in the range image, whichever way its beams turn.
    const CartesianTables points(scan);
    EXPECT_GT((points.point(114) - points.point(105)).dot(plane->across), 0.0);
    Scan other = scan;
    std::ranges::reverse(std::get<PolarGeometry>(other.geometry).beamDeg);
    const auto turned = planeThroughRock(other, rock);
    ASSERT_TRUE(turned);
    const CartesianTables seen(other);
    EXPECT_GT((seen.point(114) - seen.point(105)).dot(turned->across), 0.0);
}

} // namespace
} // namespace edgescan::inspect
