// The grid on which a point list was measured is recovered, in whatever order the list was written.
#include "core/files/grid_recovery/recover_grid.h"
#include "core/files/open_save/open_scan.h"
#include "tests/support/point_lists.h"
#include "tests/support/shared_folder.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace edgescan;
using namespace edgescan::files;
using namespace edgescan::test;

namespace {

struct Case {
    const char* name;
    ScanShape shape;
    ListStyle style;
    double tolerance = 1e-4; ///< metres between written and found points
};

std::vector<Case> cases() {
    std::vector<Case> all;
    const ScanShape sweep;
    ScanShape spin;
    spin.axis = Axis::Spin;
    spin.lines = 50;
    spin.beams = 191;
    spin.beamStart = -5;
    spin.beamStep = 1;
    spin.lineStart = 0;
    spin.lineStep = 3.6;
    ScanShape fan = spin; // the -5..185 fan in the other mounting
    fan.axis = Axis::Sweep;
    fan.lineStart = -45;
    fan.lineStep = 0.9;
    ScanShape sixths = sweep;
    sixths.beamStep = 1.0 / 6.0;
    sixths.beamStart = 45;
    sixths.lineStep = 0.18;
    ScanShape jitter = sweep;
    jitter.motorJitter = 0.6;
    ScanShape fractions = sweep;
    fractions.fraction = 1;
    for (const auto& [name, shape] : {std::pair("sweep", sweep), std::pair("spin", spin), std::pair("fan", fan),
                                      std::pair("sixths", sixths), std::pair("jitter", jitter), std::pair("fractions", fractions)}) {
        all.push_back({name, shape, {}});
        all.push_back({name, shape, {.perMetre = 100}});
        all.push_back({name, shape, {.perMetre = 1000, .format = "%.3f", .separator = ",", .lineEnd = "\r\n"}});
        all.push_back({name, shape, {.format = "%.3f", .separator = ";"}, 2e-3});
        all.push_back({name, shape, {.format = "%.9g", .separator = "\t", .beamMajor = true}});
        all.push_back({name, shape, {.reverseLines = true}});
        all.push_back({name, shape, {.reverseBeams = true}});
        all.push_back({name, shape, {.format = "%.17g", .beamMajor = true, .reverseLines = true, .reverseBeams = true}});
    }
    return all;
}

std::string describe(const Case& c, int seed) {
    return std::string(c.name) + " " + c.style.format + " x" + std::to_string(c.style.perMetre) + (c.style.beamMajor ? " beam major" : "") +
           (c.style.reverseLines ? " lines reversed" : "") + (c.style.reverseBeams ? " beams reversed" : "") +
           (c.style.shuffled ? " shuffled" : "") + " dropped " + std::to_string(c.style.dropped) + " seed " + std::to_string(seed);
}

double fewest(const std::vector<double>& values) { return *std::min_element(values.begin(), values.end()); }

} // namespace

TEST(RecogniseGrid, CompleteListsKeepEveryCell) {
    const Folder folder;
    for (Case c : cases()) {
        for (unsigned seed = 1; seed <= 2; ++seed) {
            SCOPED_TRACE(describe(c, static_cast<int>(seed)));
            c.shape.seed = seed;
            const Scan expected = makeScan(c.shape);
            writeText(folder / "list.xyz", textOf(listOf(expected, c.style), c.style));
            ReadingOptions options;
            // Centimetres that are not whole millimetres could also be metres; only the user knows.
            if (c.style.perMetre == 100 && c.shape.fraction > 0) options.unitMm = 10;
            const auto found = openScan(folder / "list.xyz", options);
            ASSERT_TRUE(found) << found.error().sentence();
            EXPECT_EQ(found->lines(), c.shape.lines);
            EXPECT_EQ(found->beams(), c.shape.beams);
            EXPECT_EQ(countCells(*found), countCells(expected));
            EXPECT_LT(farthestFrom(expected, *found), c.tolerance * 4);
            const auto& a = std::get<PolarGeometry>(expected.geometry);
            const auto& b = std::get<PolarGeometry>(found->geometry);
            EXPECT_EQ(a.axis, b.axis);
            EXPECT_NEAR(fewest(a.beamDeg), fewest(b.beamDeg), 0.02);
        }
    }
}

// Two neighbouring beams mistaken for one are exactly where one beam could be, and the rounding of the numbers hides it.
TEST(RecogniseGrid, NeighbouringBeamsOfRoundedListsStayTwo) {
    for (const Axis axis : {Axis::Spin, Axis::Sweep}) {
        for (const auto& [lines, beams] : {std::pair{90, 60}, {60, 90}, {64, 32}, {36, 72}, {45, 63}, {48, 16}}) {
            for (const char* format : {"%.3f", "%.4f"}) {
                for (const bool beamMajor : {false, true}) {
                    SCOPED_TRACE(std::to_string(lines) + " x " + std::to_string(beams) + format + (beamMajor ? " beam major" : ""));
                    Scan expected = makeScan({.axis = axis,
                                              .lines = lines,
                                              .beams = beams,
                                              .beamStart = 60,
                                              .beamStep = 60.0 / (beams - 1),
                                              .lineStart = -60,
                                              .lineStep = 120.0 / (lines - 1),
                                              .noReturns = 0});
                    for (std::size_t k = 0; k < expected.cells(); ++k) expected.rangeMm[k] = static_cast<float>(5000 + k % 7); // as a wall
                    const ListStyle style{.format = format, .beamMajor = beamMajor};
                    const std::string text = textOf(listOf(expected, style), style);
                    const auto found = readScanBytes(std::as_bytes(std::span(text)), ".xyz", {});
                    ASSERT_TRUE(found) << found.error().sentence();
                    EXPECT_EQ(found->lines(), lines);
                    EXPECT_EQ(found->beams(), beams);
                    EXPECT_LT(farthestFrom(expected, *found), 0.01);
                }
            }
        }
    }
}

TEST(RecogniseGrid, RangesOfWholeMillimetresComeBackExactly) {
    const Folder folder;
    for (const ListStyle& style :
         {ListStyle{}, ListStyle{.perMetre = 100}, ListStyle{.perMetre = 1000}, ListStyle{.perMetre = 1000, .format = "%.2f"}}) {
        const Scan expected = makeScan({});
        writeText(folder / "list.txt", textOf(listOf(expected, style), style));
        const auto found = openScan(folder / "list.txt");
        ASSERT_TRUE(found) << found.error().sentence();
        EXPECT_EQ(found->rangeMm, expected.rangeMm);
        EXPECT_EQ(found->state, expected.state);
        EXPECT_EQ(std::get<PolarGeometry>(found->geometry), std::get<PolarGeometry>(expected.geometry));
        const std::string unit = style.perMetre == 1     ? "Unit taken as metres"
                                 : style.perMetre == 100 ? "Unit taken as centimetres"
                                                         : "Unit taken as millimetres";
        EXPECT_TRUE(std::any_of(found->warnings.begin(), found->warnings.end(), [&](const auto& w) { return w.starts_with(unit); }))
            << unit;
    }
}

TEST(RecogniseGrid, AUnitThatGivesKilometresIsDoubted) {
    const Folder folder;
    for (const double perMetre : {1.0, 1000.0}) {
        const ListStyle style{.perMetre = perMetre};
        writeText(folder / "list.txt", textOf(listOf(makeScan({}), style), style));
        ReadingOptions metres;
        metres.unitMm = 1000.0;
        const auto found = openScan(folder / "list.txt", metres);
        ASSERT_TRUE(found) << found.error().sentence();
        const bool doubted =
            std::ranges::any_of(found->warnings, [](const auto& w) { return w.find("give --unit mm") != std::string::npos; });
        EXPECT_EQ(doubted, perMetre == 1000.0);
    }
}

TEST(RecogniseGrid, DroppedAndShuffledPointsFindTheirCells) {
    const Folder folder;
    for (const char* format : {"%.6g", "%.9g", "%.4f"}) {
        for (const bool shuffled : {false, true}) {
            for (const double dropped : {0.02, 0.3, 0.6}) {
                for (const Axis axis : {Axis::Sweep, Axis::Spin}) {
                    ScanShape shape;
                    shape.axis = axis;
                    shape.motorJitter = dropped > 0.1 ? 0.5 : 0;
                    shape.beamStart = axis == Axis::Sweep ? 20 : -60; // the axis is not on a beam
                    const ListStyle style{.format = format, .shuffled = shuffled, .dropped = dropped, .keepMissing = false};
                    SCOPED_TRACE(describe({"", shape, style}, 1));
                    const Scan expected = makeScan(shape);
                    const auto points = listOf(expected, style);
                    writeText(folder / "list.xyz", textOf(points, style));
                    const auto found = openScan(folder / "list.xyz");
                    ASSERT_TRUE(found) << found.error().sentence();
                    EXPECT_EQ(found->lines(), shape.lines);
                    EXPECT_EQ(found->beams(), shape.beams);
                    EXPECT_EQ(countCells(*found)[0], points.size());
                    const auto& a = std::get<PolarGeometry>(expected.geometry);
                    const auto& b = std::get<PolarGeometry>(found->geometry);
                    ASSERT_EQ(a.lineDeg.size(), b.lineDeg.size());
                    const bool turned = shuffled; // a shuffled list has no direction; angles then ascend
                    for (std::size_t i = 0; i < a.lineDeg.size(); ++i)
                        EXPECT_NEAR(a.lineDeg[turned ? a.lineDeg.size() - 1 - i : i], b.lineDeg[i], 0.01);
                }
            }
        }
    }
}

TEST(RecogniseGrid, FanAcrossTheAxisWithDroppedPoints) {
    const Folder folder;
    for (const Axis axis : {Axis::Sweep, Axis::Spin}) {
        ScanShape shape{.axis = axis, .lines = 90, .beams = 191, .beamStart = -5, .beamStep = 1, .lineStart = 0, .lineStep = 2};
        const ListStyle style{.format = "%.5f", .dropped = 0.1, .keepMissing = false};
        const Scan expected = makeScan(shape);
        const auto points = listOf(expected, style);
        writeText(folder / "list.xyz", textOf(points, style));
        const auto found = openScan(folder / "list.xyz");
        ASSERT_TRUE(found) << found.error().sentence();
        EXPECT_EQ(found->lines(), 90);
        EXPECT_EQ(found->beams(), 191);
        EXPECT_GE(countCells(*found)[0] + 20, points.size());
        EXPECT_NEAR(std::get<PolarGeometry>(found->geometry).beamDeg.front(), -5, 0.01);
    }
}

// Found as planes through the axis, whose beams point to both sides and would exceed 360 degrees.
TEST(RecogniseGrid, SpinningBeamsInAnyOrderAreLinesAllRound) {
    for (const ScanShape& shape :
         {ScanShape{.axis = Axis::Spin, .lines = 240, .beams = 16, .beamStart = -15, .beamStep = 2, .lineStart = 0, .lineStep = 1.5},
          ScanShape{.axis = Axis::Spin, .lines = 120, .beams = 40, .beamStart = -25, .beamStep = 1, .lineStart = 0, .lineStep = 3}}) {
        for (const double dropped : {0.0, 0.05}) {
            const ListStyle style{.format = "%.4f", .shuffled = true, .dropped = dropped, .keepMissing = false};
            const Scan expected = makeScan(shape);
            const auto points = listOf(expected, style);
            const std::string text = textOf(points, style);
            const auto found = readScanBytes(std::as_bytes(std::span(text)), ".xyz", {});
            ASSERT_TRUE(found) << found.error().sentence();
            EXPECT_EQ(found->lines(), shape.lines);
            EXPECT_EQ(found->beams(), shape.beams);
            EXPECT_EQ(countCells(*found)[0], points.size());
            const auto& beams = std::get<PolarGeometry>(found->geometry).beamDeg;
            EXPECT_NEAR(std::min(beams.front(), beams.back()), shape.beamStart, 0.01);
        }
    }
}

TEST(RecogniseGrid, FullTurnsOfATerrestrialScannerStayFullTurns) {
    const Folder folder;
    ScanShape shape{.axis = Axis::Spin, .lines = 180, .beams = 50, .beamStart = -40, .beamStep = 2, .lineStart = 0, .lineStep = 2};
    for (const double dropped : {0.0, 0.1}) {
        const ListStyle style{.format = "%.5f", .dropped = dropped, .keepMissing = dropped == 0.0};
        const Scan expected = makeScan(shape);
        writeText(folder / "list.xyz", textOf(listOf(expected, style), style));
        const auto found = openScan(folder / "list.xyz");
        ASSERT_TRUE(found) << found.error().sentence();
        EXPECT_EQ(found->lines(), 180);
        EXPECT_EQ(found->beams(), 50);
        EXPECT_NEAR(std::get<PolarGeometry>(found->geometry).beamDeg.front(), -40, 0.01);
    }
}

TEST(RecogniseGrid, LinesStoredTwiceAreLeftOutAndReported) {
    const Folder folder;
    const ListStyle style{.doubledLines = true};
    const Scan expected = makeScan({});
    writeText(folder / "list.xyz", textOf(listOf(expected, style), style));
    const auto found = openScan(folder / "list.xyz");
    ASSERT_TRUE(found) << found.error().sentence();
    EXPECT_EQ(found->rangeMm, expected.rangeMm);
    EXPECT_TRUE(
        std::any_of(found->warnings.begin(), found->warnings.end(), [](const auto& w) { return w.starts_with("40 lines repeated"); }));
}

TEST(RecogniseGrid, LinesWithoutAnyReturnTakeTheirAngleFromTheNeighbours) {
    const Folder folder;
    Scan expected = makeScan({});
    for (const int line : {0, 17, 18, 39}) {
        for (int j = 0; j < expected.beams(); ++j) {
            expected.state.at(line, j) = CellState::NoReturn;
            expected.rangeMm.at(line, j) = 0;
        }
    }
    writeText(folder / "list.xyz", textOf(listOf(expected, {}), {}));
    const auto found = openScan(folder / "list.xyz");
    ASSERT_TRUE(found) << found.error().sentence();
    EXPECT_EQ(found->rangeMm, expected.rangeMm);
    EXPECT_EQ(std::get<PolarGeometry>(found->geometry), std::get<PolarGeometry>(expected.geometry));
}

TEST(RecogniseGrid, RotationAboutYIsConvertedAndReported) {
    const Folder folder;
    ScanShape shape{.axis = Axis::Spin, .lines = 30, .beams = 50, .beamStart = -40, .beamStep = 1.5, .lineStart = 10, .lineStep = 2};
    const Scan expected = makeScan(shape);
    auto points = listOf(expected, {});
    for (auto& p : points) p = Eigen::Vector3d(p.y(), p.z(), p.x());
    writeText(folder / "list.xyz", textOf(points, {}));
    const auto found = openScan(folder / "list.xyz");
    ASSERT_TRUE(found) << found.error().sentence();
    EXPECT_EQ(found->rangeMm, expected.rangeMm);
    EXPECT_EQ(std::get<PolarGeometry>(found->geometry), std::get<PolarGeometry>(expected.geometry));
    EXPECT_FALSE(found->warnings.empty());
}

TEST(RecogniseGrid, CloudsWithoutGridAreRefusedWithNumbers) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> coordinate(-5, 5);
    for (const std::size_t count : {13U, 60U, 1000U, 6000U}) {
        std::vector<Eigen::Vector3d> points;
        for (std::size_t k = 0; k < count; ++k) points.emplace_back(coordinate(random), coordinate(random), coordinate(random));
        const auto found = recoverGrid({points, {0.0, 1e-7}, 0, {}, {}});
        ASSERT_FALSE(found) << count;
        EXPECT_NE(found.error().what.find(std::to_string(count) + " points"), std::string::npos) << found.error().sentence();
    }
    EXPECT_FALSE(recoverGrid({}));
}

TEST(RecogniseGrid, RasterOnAPlaneIsNoScannerGrid) {
    std::vector<Eigen::Vector3d> points;
    for (int i = 0; i < 60; ++i) {
        for (int j = 0; j < 60; ++j) points.emplace_back(0.1 * j - 2.93, 0.1 * i - 2.87, 4.03);
    }
    EXPECT_FALSE(recoverGrid({points, {0.0005, 0}, 0, {}, {}}));
}

TEST(RecogniseGrid, CorridorFilesEqualTheirRawGrids) {
    EDGESCAN_NEEDS_SHARED("data/lms200_corridor");
    for (const std::string name : {"scan000", "scan001"}) {
        const std::filesystem::path base = edgescan::test::sharedFolder() / "data/lms200_corridor" / name;
        const auto list = openScan(base.string() + ".3d");
        const auto raw = openScan(base.string() + ".json");
        ASSERT_TRUE(list) << list.error().sentence();
        ASSERT_TRUE(raw) << raw.error().sentence();
        EXPECT_EQ(list->rangeMm, raw->rangeMm);
        EXPECT_EQ(list->state, raw->state);
        EXPECT_EQ(list->statusCodes, raw->statusCodes);
        const auto& a = std::get<PolarGeometry>(list->geometry);
        const auto& b = std::get<PolarGeometry>(raw->geometry);
        EXPECT_EQ(a.beamDeg, b.beamDeg);
        EXPECT_EQ(a.axis, b.axis);
        EXPECT_EQ(a.lineDirection, -1.0);
        for (std::size_t i = 0; i < b.lineDeg.size(); ++i) EXPECT_NEAR(a.lineDeg[i], b.lineDeg[i], 1e-3);
    }
}

TEST(RecogniseGrid, RealCloudsWithoutGridAreRefusedWhereTheyMustNotBeProjected) {
    EDGESCAN_NEEDS_SHARED("data/traps");
    ReadingOptions options;
    options.projection = Projection::Never;
    for (const std::string name :
         {"traps/livox_bin_unorganized.pcd", "traps/airborne_utm_float32.pcd", "otira_rocks/Otira_1cm_grains.ply"}) {
        const auto scan = openScan(edgescan::test::sharedFolder() / "data" / name, options);
        ASSERT_FALSE(scan) << name;
        EXPECT_NE(scan.error().what.find("do not lie on beam x line angles"), std::string::npos) << scan.error().sentence();
    }
}
