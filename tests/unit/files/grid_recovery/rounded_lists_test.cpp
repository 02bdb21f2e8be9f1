// The grid is recovered from bare lists of rounded points: in order or shuffled, with points left out, with a motor that stops or rotates
// continuously; and columns that name line and beam are the grid. The files are written without the program's own writers.
#include "tests/support/point_lists.h"
#include "tests/support/point_round_trip.h"

#include <gtest/gtest.h>

#include <numeric>

using namespace edgescan;
using namespace edgescan::files;
using namespace edgescan::test;

namespace {

/// Boxes in front of a wall, ranges in whole millimetres with a little noise.
Scan boxesBeforeWall(Axis axis, int lines, int beams, double beamStart, double beamStep, double lineStart, double lineStep,
                     unsigned seed = 3) {
    ScanShape shape{.axis = axis,
                    .lines = lines,
                    .beams = beams,
                    .beamStart = beamStart,
                    .beamStep = beamStep,
                    .lineStart = lineStart,
                    .lineStep = lineStep,
                    .noReturns = 0.01,
                    .seed = seed};
    Scan scan = makeScan(shape);
    std::mt19937 random(seed);
    for (int i = 0; i < lines; ++i) {
        for (int j = 0; j < beams; ++j) {
            const bool box = (i / 17 + j / 23) % 3 == 0;
            float& range = scan.rangeMm.at(i, j);
            // On the axis all lines see the same.
            const bool onAxis = axis == Axis::Sweep && std::abs(std::sin((beamStart + j * beamStep) * std::numbers::pi / 180)) < 0.1;
            if (range > 0 && onAxis)
                range = 5200;
            else if (range > 0)
                range = static_cast<float>((box ? 3000 : 5200) + 3 * i + 2 * j + static_cast<int>(random() % 9));
        }
    }
    return scan;
}

std::string textWith(const Scan& scan, const std::string& header,
                     const std::function<std::string(const Eigen::Vector3d&, std::size_t)>& row) {
    const CartesianTables tables(scan);
    std::string text = header;
    for (std::size_t k = 0; k < scan.cells(); ++k) {
        if (scan.state[k] == CellState::Valid) text += row(tables.point(k), k) + "\n";
    }
    return text;
}

std::string three(double a, double b, double c) {
    std::array<char, 120> text{};
    std::snprintf(text.data(), text.size(), "%.3f,%.3f,%.3f", a, b, c);
    return text.data();
}

Result<Scan> opened(const std::string& text, const std::string& extension, const ReadingOptions& options = {}) {
    return readScanBytes(std::as_bytes(std::span(text)), extension, options);
}

} // namespace

TEST(RoundedLists, NoPointIsLostAndTheMaskStays) {
    for (const Scan& scan :
         {boxesBeforeWall(Axis::Sweep, 120, 191, -5, 1, -60, 1), boxesBeforeWall(Axis::Spin, 90, 180, -40, 0.5, 10, 0.75)}) {
        for (const char* format : {"xyz", "las", "pcd"}) {
            for (const int decimals : {3, 4, 5}) {
                for (const bool shuffled : {false, true}) {
                    for (const double thinned : {0.0, 0.05}) {
                        SCOPED_TRACE(std::string(format) + " " + std::to_string(decimals) + (shuffled ? " shuffled " : " in order ") +
                                     std::to_string(thinned));
                        const CameBack back = roundTrip(scan, {format, decimals, shuffled, thinned});
                        ASSERT_EQ(back.problem, "");
                        EXPECT_EQ(back.lines, scan.lines());
                        EXPECT_EQ(back.beams, scan.beams());
                        EXPECT_EQ(back.lost, 0U);
                        EXPECT_EQ(back.movedClear, 0U); // points in another cell had an undefined line
                        if (!shuffled) {
                            EXPECT_EQ(back.moved, 0U);
                        }
                        if (!shuffled && decimals > 3) {
                            EXPECT_EQ(back.differ, 0U);
                        } else {
                            EXPECT_LT(static_cast<double>(back.differ), 0.005 * static_cast<double>(scan.cells()));
                        }
                    }
                }
            }
        }
    }
}

TEST(RoundedLists, LinesOfAStoppedMotorStayLines) {
    Scan scan = boxesBeforeWall(Axis::Spin, 318, 181, -45, 0.5, 0, 1.2); // past 360 degrees
    auto& polar = std::get<PolarGeometry>(scan.geometry);
    for (const std::size_t stands : {100U, 101U, 200U}) polar.lineDeg[stands] = polar.lineDeg[stands - 1];
    for (const int decimals : {3, 4, 6}) {
        for (const double thinned : {0.0, 0.05}) {
            const CameBack back = roundTrip(scan, {"xyz", decimals, false, thinned});
            SCOPED_TRACE(decimals);
            ASSERT_EQ(back.problem, "");
            EXPECT_EQ(back.lines, 318);
            EXPECT_EQ(back.beams, 181);
            EXPECT_EQ(back.lost, 0U);
            EXPECT_EQ(back.moved, 0U);
        }
    }
}

TEST(RoundedLists, LinesOutOfOrderAreSortedByTheirAngles) {
    const Scan scan = boxesBeforeWall(Axis::Sweep, 60, 120, 20, 1, -30, 1);
    std::vector<int> order(60);
    std::iota(order.begin(), order.end(), 0);
    std::swap(order[10], order[40]);
    std::swap(order[21], order[22]);
    const CartesianTables tables(scan);
    Points points;
    for (const int i : order) {
        for (int j = 0; j < scan.beams(); ++j) {
            if (scan.state.at(i, j) == CellState::Valid) points.push_back(tables.point(i, j));
        }
    }
    const auto found = opened(pointText(points, 4), ".xyz");
    ASSERT_TRUE(found) << found.error().sentence();
    const CameBack back = compared(scan, *found, points.size(), 1.5);
    EXPECT_EQ(back.lines, 60);
    EXPECT_EQ(back.lost, 0U);
    EXPECT_EQ(back.moved, 0U);
    EXPECT_EQ(back.differ, 0U);
}

TEST(RoundedLists, ColumnsOfLinesAndBeamsAreTheGrid) {
    const Scan scan = boxesBeforeWall(Axis::Sweep, 50, 60, 30, 1, -25, 1);
    const auto beams = static_cast<std::size_t>(scan.beams());
    const auto mask = maskOf(scan);
    for (const auto& [header, first] : {std::pair("x,y,z,line,beam\n", 0), std::pair("X,Y,Z,Row,Col\n", 1),
                                        std::pair("\"x [m]\",\"y [m]\",\"z [m]\",RING,Column\n", 0)}) {
        const std::string text =
            textWith(scan, header, [&, from = static_cast<std::size_t>(first)](const Eigen::Vector3d& p, std::size_t k) {
                return three(p.x(), p.y(), p.z()) + "," + std::to_string(k / beams + from) + "," + std::to_string(k % beams + from);
            });
        const auto found = opened(text, ".csv");
        ASSERT_TRUE(found) << found.error().sentence();
        ASSERT_EQ(found->lines(), scan.lines());
        ASSERT_EQ(found->beams(), scan.beams());
        EXPECT_EQ(found->state, scan.state);
        EXPECT_EQ(found->pointsLeftOut, 0U);
        EXPECT_TRUE(std::holds_alternative<PolarGeometry>(found->geometry));
    }
    WholeColumn line{"Line", {}}, beam{"Beam", {}};
    const WrittenPoints written = writtenPoints(scan, {.decimals = 6, .shuffled = true});
    for (const std::uint32_t k : written.cell) {
        line.values.push_back(static_cast<std::uint32_t>(k / beams));
        beam.values.push_back(static_cast<std::uint32_t>(k % beams));
    }
    for (const auto& [bytes, extension] :
         {std::pair(pointPcd(written.points, {line, beam}), ".pcd"), std::pair(pointPly(written.points, {line, beam}), ".ply")}) {
        const auto found = opened(bytes, extension);
        ASSERT_TRUE(found) << found.error().sentence();
        EXPECT_EQ(found->state, scan.state);
        EXPECT_EQ(found->rangeMm, scan.rangeMm);
        EXPECT_EQ(std::get<PolarGeometry>(found->geometry), std::get<PolarGeometry>(scan.geometry));
        EXPECT_EQ(*maskOf(*found), *mask);
    }
}

TEST(RoundedLists, ColumnsOfAnotherFrameGiveTheSameMask) {
    const Scan scan = boxesBeforeWall(Axis::Sweep, 50, 60, 30, 1, -25, 1);
    const auto beams = static_cast<std::size_t>(scan.beams());
    Eigen::Matrix3d turn; // no axis of the scanner is parallel to an axis of the frame
    turn << 0.36, 0.48, -0.8, -0.8, 0.6, 0.0, 0.48, 0.64, 0.6;
    const Eigen::Vector3d place(498765.25, 5150123.5, 287.625);
    const std::string text =
        textWith(scan, "id,Northing,Easting,Elevation,line,beam,range_mm\n", [&](const Eigen::Vector3d& p, std::size_t k) {
            const Eigen::Vector3d q = turn * p + place;
            return std::to_string(k + 1) + "," + three(q.y(), q.x(), q.z()) + "," + std::to_string(k / beams) + "," +
                   std::to_string(k % beams) + "," + std::to_string(static_cast<int>(scan.rangeMm[k]));
        });
    const auto found = opened(text, ".csv");
    ASSERT_TRUE(found) << found.error().sentence();
    EXPECT_EQ(found->rangeMm, scan.rangeMm);
    EXPECT_EQ(found->state, scan.state);
    EXPECT_EQ(*maskOf(*found), *maskOf(scan));
    ASSERT_TRUE(found->placement);
    EXPECT_LT((found->placement->originEnhM + found->placement->poses.front().translationM - place).norm(), 0.005);
    EXPECT_LT((turn * CartesianTables(scan).point(20, 20) + place - minePoint(*found, scan.rangeMm.index(20, 20)).enhM).norm(), 0.001);
}

TEST(RoundedLists, NamesOfCoordinatesAreTakenInTheirOrder) {
    const Scan scan = boxesBeforeWall(Axis::Sweep, 40, 60, 30, 1, -25, 1);
    const auto northFirst = [](const Eigen::Vector3d& p, std::size_t k) { return std::to_string(k) + "," + three(p.y(), p.x(), p.z()); };
    const auto eastFirst = [](const Eigen::Vector3d& p, std::size_t k) { return std::to_string(k) + "," + three(p.x(), p.y(), p.z()); };
    for (const auto& [header, row] : {std::pair<std::string, decltype(+eastFirst)>{"id,Northing,Easting,Elevation", northFirst},
                                      {"Point,N,E,Z", northFirst},
                                      {"Pt,East,North,Height", eastFirst},
                                      {"no,Easting (m),Northing (m),RL (m)", eastFirst},
                                      {"index,X(m),Y(m),Z(m)", eastFirst}}) {
        const auto found = opened(textWith(scan, header + "\n", row), ".csv");
        ASSERT_TRUE(found) << header << found.error().sentence();
        EXPECT_EQ(found->lines(), scan.lines()) << header;
        EXPECT_EQ(found->beams(), scan.beams()) << header;
        EXPECT_LT(farthestFrom(scan, *found), 0.004) << header;
        EXPECT_EQ(std::get<PolarGeometry>(found->geometry).axis, Axis::Sweep) << header;
    }
}

TEST(RoundedLists, AKnownSensorCostsNoPrecision) {
    const Scan scan = boxesBeforeWall(Axis::Sweep, 80, 120, 30, 0.5, -25, 0.5);
    for (const int decimals : {3, 5}) {
        const CameBack back = roundTrip(scan, {"xyz", decimals, false, 0.0, Eigen::Vector3d(12.5, -3.25, 1.75)});
        ASSERT_EQ(back.problem, "");
        EXPECT_EQ(back.lost, 0U);
        EXPECT_EQ(back.moved, 0U);
        if (decimals > 3) {
            EXPECT_EQ(back.differ, 0U);
        }
    }
}

TEST(RoundedLists, PointsWithoutACellAreCounted) {
    const Scan scan = boxesBeforeWall(Axis::Sweep, 40, 60, 30, 1, -25, 1);
    WrittenPoints written = writtenPoints(scan, {.decimals = 5});
    const std::size_t points = written.points.size();
    for (std::size_t n = 0; n < 30; ++n) written.points.push_back(written.points[n * 30] * 1.01); // a second return of the same beam
    const auto found = opened(pointText(written.points, 5), ".xyz");
    ASSERT_TRUE(found) << found.error().sentence();
    EXPECT_EQ(found->pointsRead, points + 30);
    EXPECT_EQ(found->pointsLeftOut, points + 30 - countCells(*found)[0]);
    EXPECT_EQ(found->pointsLeftOut, 30U);
    const std::string sentence = "30 of the " + std::to_string(points + 30) + " points of the file have no cell of their own.";
    EXPECT_NE(std::find(found->warnings.begin(), found->warnings.end(), sentence), found->warnings.end());
}

TEST(RoundedLists, LinesOfDifferentPhasesMakeOne) {
    const Scan whole = boxesBeforeWall(Axis::Sweep, 80, 160, 30, 0.25, -40, 1);
    const CartesianTables tables(whole);
    Points points;
    for (int i = 0; i < whole.lines(); ++i) {
        for (int j = i % 4; j < whole.beams(); j += 4) {
            if (whole.state.at(i, j) == CellState::Valid) points.push_back(tables.point(i, j));
        }
    }
    const auto found = opened(pointText(points, 5), ".xyz");
    ASSERT_TRUE(found) << found.error().sentence();
    EXPECT_EQ(found->lines(), 20);
    EXPECT_EQ(found->beams(), 160);
    EXPECT_EQ(countCells(*found)[0], points.size());
    const auto& polar = std::get<PolarGeometry>(found->geometry);
    ASSERT_EQ(polar.lineSkewDeg.size(), 160U);
    EXPECT_NEAR(polar.lineSkewDeg[3] - polar.lineSkewDeg[0], 3.0, 1e-3);
    EXPECT_NEAR(polar.lineDeg[1] - polar.lineDeg[0], 4.0, 1e-3);
    const CartesianTables foundTables(*found);
    EXPECT_LT((tables.point(9, 41) - foundTables.point(2, 41)).norm(), 0.002);
}
