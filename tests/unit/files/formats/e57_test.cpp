// E57: files of other programs, and files of a writer that shares no code with the reader.
#include "core/containers/e57/columns.h"
#include "core/files/formats/formats.h"
#include "core/scan/grid/acquisition.h"
#include "core/scan/grid/placement.h"
#include "tests/support/e57_writer.h"
#include "tests/support/point_lists.h"
#include "tests/support/shared_folder.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <random>

using namespace edgescan;
using namespace edgescan::files;
using namespace edgescan::test;

namespace {

using As = E57Column::As;

bool e57Told(const Scan& scan, const std::string& part) {
    return std::ranges::any_of(scan.warnings, [&](const std::string& w) { return w.find(part) != std::string::npos; });
}

/// The valid cells of a scan as a list in any order, each with its row and column.
struct E57Cells {
    std::vector<Eigen::Vector3d> points;
    std::vector<double> lines, beams;
};
E57Cells e57CellsOf(const Scan& scan, unsigned seed) {
    const CartesianTables tables(scan);
    std::vector<std::size_t> order;
    for (std::size_t k = 0; k < scan.cells(); ++k) {
        if (scan.state[k] == CellState::Valid) order.push_back(k);
    }
    std::mt19937 random(seed);
    if (seed != 0) std::shuffle(order.begin(), order.end(), random);
    E57Cells cells;
    for (const std::size_t k : order) {
        cells.points.push_back(tables.point(k));
        cells.lines.push_back(static_cast<double>(k / static_cast<std::size_t>(scan.beams())));
        cells.beams.push_back(static_cast<double>(k % static_cast<std::size_t>(scan.beams())));
    }
    return cells;
}

std::string e57Bounds(const Scan& scan) {
    return "<indexBounds type=\"Structure\"><rowMinimum type=\"Integer\">0</rowMinimum><rowMaximum type=\"Integer\">" +
           std::to_string(scan.beams() - 1) + "</rowMaximum><columnMinimum type=\"Integer\"/><columnMaximum type=\"Integer\">" +
           std::to_string(scan.lines() - 1) + "</columnMaximum></indexBounds>";
}

std::vector<E57Column> e57Spherical(const std::vector<Eigen::Vector3d>& points, As as) {
    std::vector<E57Column> columns{{"sphericalRange"}, {"sphericalAzimuth"}, {"sphericalElevation"}};
    for (const auto& p : points) {
        columns[0].values.push_back(p.norm());
        columns[1].values.push_back(std::atan2(p.y(), p.x()));
        columns[2].values.push_back(std::asin(p.z() / p.norm()));
    }
    for (E57Column& column : columns) {
        column.as = as;
        column.scale = &column == &columns[0] ? 1e-5 : 1e-8;
        column.minimum = -2'000'000'000;
        column.maximum = 2'000'000'000;
    }
    return columns;
}

std::string groupedBy(const std::string& index) {
    return "<pointGroupingSchemes type=\"Structure\"><groupingByLine type=\"Structure\"><idElementName type=\"String\"><![CDATA[" + index +
           "]]></idElementName></groupingByLine></pointGroupingSchemes>";
}

/// Reads a file whose rows are the scan's lines.
Result<Scan> readWithLinesAsRows(const Scan& scan, const std::string& grouping) {
    const E57Cells cells = e57CellsOf(scan, 9);
    E57Part part{e57Cartesian(cells.points), grouping};
    part.columns.push_back(e57Whole("rowIndex", cells.lines));
    part.columns.push_back(e57Whole("columnIndex", cells.beams));
    return readBytes(e57Bytes({part}), ".e57");
}

std::string sharedE57(const std::string& name) { return readText(edgescan::test::sharedFolder() / "data/e57" / name); }

} // namespace

TEST(E57, ChecksumIsThatOfCastagnoli) {
    const std::string digits = "123456789"; // RFC 3720, appendix B.4, and the usual check value
    EXPECT_EQ(containers::crc32c(std::as_bytes(std::span(digits))), 0xE3069283U);
    const std::string zeros(32, '\0');
    EXPECT_EQ(containers::crc32c(std::as_bytes(std::span(zeros))), 0x8A9136AAU);
    std::mt19937 random(3);
    for (std::size_t length = 0; length < 70; ++length) {
        std::string bytes(length, '\0');
        for (char& byte : bytes) byte = static_cast<char>(random());
        EXPECT_EQ(containers::crc32c(std::as_bytes(std::span(bytes))), slowCrc32c(bytes));
    }
}

TEST(E57, EveryWidthOfBitsIsUnpacked) {
    std::mt19937_64 random(11);
    for (const std::size_t packet : {std::size_t{5}, std::size_t{97}, std::size_t{700}}) {
        E57Part part;
        part.bytesPerPacket = packet;
        constexpr std::size_t kPoints = 203;
        for (int bits = 0; bits <= 53; ++bits) { // the integers that a double holds exactly
            E57Column column{"c" + std::to_string(bits), As::Integer, {}};
            column.minimum = bits % 3 == 0 ? 0 : -static_cast<std::int64_t>(random() % 1000);
            column.maximum = column.minimum + static_cast<std::int64_t>((std::uint64_t{1} << bits) - 1);
            for (std::size_t n = 0; n < kPoints; ++n) {
                const std::uint64_t raw = bits == 0 ? 0 : random() >> (64 - bits);
                column.values.push_back(static_cast<double>(column.minimum + static_cast<std::int64_t>(raw)));
            }
            part.columns.push_back(column);
        }
        const std::string bytes = e57Bytes({part});
        auto file = containers::openE57(std::as_bytes(std::span(bytes)), "test");
        ASSERT_TRUE(file) << file.error().sentence();
        std::vector<std::size_t> all(part.columns.size());
        for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
        const auto numbers = containers::readE57Columns(*file, file->scans.at(0), all, [](double) { return true; });
        ASSERT_TRUE(numbers) << numbers.error().sentence();
        for (std::size_t i = 0; i < all.size(); ++i) EXPECT_EQ((*numbers)[i], part.columns[i].values) << part.columns[i].name;
    }
}

TEST(E57, GridsComeBackAsTheGridsTheyAre) {
    for (const Axis axis : {Axis::Spin, Axis::Sweep}) {
        for (const unsigned seed : {0U, 5U}) {
            for (const bool bounds : {false, true}) {
                ScanShape shape;
                shape.axis = axis;
                shape.beamStart = axis == Axis::Sweep ? 20 : -15;
                shape.noReturns = 0.2;
                const Scan expected = makeScan(shape);
                const E57Cells cells = e57CellsOf(expected, seed);
                for (const As as : {As::Double, As::Single, As::Scaled}) {
                    E57Part part{e57Cartesian(cells.points, as), bounds ? e57Bounds(expected) : ""};
                    part.columns.push_back(e57Whole("rowIndex", cells.beams));
                    part.columns.insert(part.columns.begin(), e57Whole("columnIndex", cells.lines));
                    const auto scan = readBytes(e57Bytes({part}), ".e57");
                    ASSERT_TRUE(scan) << scan.error().sentence();
                    EXPECT_EQ(scan->format, "E57");
                    EXPECT_EQ(scan->rangeMm, expected.rangeMm);
                    EXPECT_EQ(scan->state, expected.state);
                    EXPECT_EQ(std::get<PolarGeometry>(scan->geometry), std::get<PolarGeometry>(expected.geometry));
                    EXPECT_TRUE(e57Told(*scan, "columns were taken as lines"));
                }
            }
        }
    }
}

TEST(E57, LinesAreRowsWhereTheFileSaysSo) {
    const Scan expected = makeScan(ScanShape{});
    const auto scan = readWithLinesAsRows(expected, groupedBy("rowIndex"));
    ASSERT_TRUE(scan) << scan.error().sentence();
    EXPECT_EQ(scan->rangeMm, expected.rangeMm);
    EXPECT_EQ(scan->state, expected.state);
    EXPECT_FALSE(e57Told(*scan, "taken as lines"));
}

TEST(E57, LinesAreRowsWhereOnlyThatMakesFans) {
    const Scan expected = makeScan({.beamStart = 20, .noReturns = 0.2});
    for (const std::string& grouping : {std::string(), groupedBy("columnIndex")}) { // unsaid, and wrong
        const auto scan = readWithLinesAsRows(expected, grouping);
        ASSERT_TRUE(scan) << scan.error().sentence();
        EXPECT_EQ(scan->rangeMm, expected.rangeMm);
        EXPECT_EQ(scan->state, expected.state);
        EXPECT_TRUE(e57Told(*scan, "Lines and beams were exchanged"));
    }
}

TEST(E57, SphericalGridsAreTheSameGrids) {
    ScanShape shape;
    shape.axis = Axis::Spin;
    shape.beamStart = -15;
    const Scan expected = makeScan(shape);
    const E57Cells cells = e57CellsOf(expected, 3);
    for (const As as : {As::Double, As::Single, As::Scaled}) {
        E57Part part{e57Spherical(cells.points, as), e57Bounds(expected)};
        part.columns.push_back(e57Whole("rowIndex", cells.beams));
        part.columns.push_back(e57Whole("columnIndex", cells.lines));
        const auto scan = readBytes(e57Bytes({part}), ".e57");
        ASSERT_TRUE(scan) << scan.error().sentence();
        EXPECT_EQ(scan->rangeMm, expected.rangeMm);
        EXPECT_EQ(scan->state, expected.state);
        EXPECT_EQ(std::get<PolarGeometry>(scan->geometry), std::get<PolarGeometry>(expected.geometry));
    }
}

TEST(E57, SphericalRangesBelowZeroAreNoReturnsAndDegreesAreAngles) {
    const Scan expected = makeScan({.axis = Axis::Spin, .beamStart = -15});
    const E57Cells cells = e57CellsOf(expected, 3);
    constexpr std::size_t kBelow = 40;
    std::vector<E57Column> columns = e57Spherical(cells.points, As::Double);
    std::fill_n(columns[0].values.begin(), kBelow, -1.0);
    for (const std::size_t angle : {1U, 2U}) {
        for (double& value : columns[angle].values) value *= 180 / std::numbers::pi;
    }
    E57Part part{columns, e57Bounds(expected)};
    part.columns.push_back(e57Whole("rowIndex", cells.beams));
    part.columns.push_back(e57Whole("columnIndex", cells.lines));
    const auto scan = readBytes(e57Bytes({part}), ".e57");
    ASSERT_TRUE(scan) << scan.error().sentence();
    EXPECT_TRUE(e57Told(*scan, "40 points have a range below 0") && e57Told(*scan, "taken as degrees"));
    Scan wanted = expected;
    for (std::size_t n = 0; n < kBelow; ++n) {
        const int line = static_cast<int>(cells.lines[n]), beam = static_cast<int>(cells.beams[n]);
        wanted.rangeMm.at(line, beam) = 0;
        wanted.state.at(line, beam) = CellState::NoReturn;
    }
    EXPECT_EQ(scan->rangeMm, wanted.rangeMm);
    EXPECT_EQ(scan->state, wanted.state);
    EXPECT_EQ(std::get<PolarGeometry>(scan->geometry), std::get<PolarGeometry>(expected.geometry));
}

TEST(E57, GridsWithoutEvenAnglesKeepEveryCell) {
    // Every point slightly off its beam, as from a scanner on a walking robot: no angles fit, and the cells are unchanged.
    const Scan made = makeScan(ScanShape{.lines = 23, .beams = 31});
    E57Cells cells = e57CellsOf(made, 4);
    std::mt19937 random(8);
    std::uniform_real_distribution<double> off(-0.02, 0.02);
    for (auto& p : cells.points) p += Eigen::Vector3d(off(random), off(random), off(random));
    E57Part part{e57Cartesian(cells.points), e57Bounds(made)};
    part.columns.push_back(e57Whole("rowIndex", cells.beams));
    part.columns.push_back(e57Whole("columnIndex", cells.lines));
    const auto scan = readBytes(e57Bytes({part}), ".e57");
    ASSERT_TRUE(scan) << scan.error().sentence();
    ASSERT_EQ(scan->lines(), made.lines());
    ASSERT_EQ(scan->beams(), made.beams());
    EXPECT_EQ(scan->state, made.state);
    const auto& geometry = std::get<PointGeometry>(scan->geometry);
    for (std::size_t n = 0; n < cells.points.size(); ++n)
        EXPECT_EQ(geometry.pointsM.at(static_cast<int>(cells.lines[n]), static_cast<int>(cells.beams[n])), cells.points[n]);
}

TEST(E57, LinesThatRepeatTheLineBeforeStayWhereTheFileCountsThem) {
    // A list in order would lose them: here the file itself says that they are separate lines.
    Scan made = makeScan(ScanShape{.noReturns = 0});
    E57Cells cells = e57CellsOf(made, 0);
    const auto beams = static_cast<std::size_t>(made.beams());
    for (std::size_t j = 0; j < beams; ++j) cells.points[7 * beams + j] = cells.points[6 * beams + j];
    E57Part part{e57Cartesian(cells.points), ""};
    part.columns.push_back(e57Whole("rowIndex", cells.beams));
    part.columns.push_back(e57Whole("columnIndex", cells.lines));
    const auto scan = readBytes(e57Bytes({part}), ".e57");
    ASSERT_TRUE(scan) << scan.error().sentence();
    EXPECT_EQ(scan->lines(), made.lines());
    EXPECT_EQ(scan->beams(), made.beams());
    EXPECT_EQ(countCells(*scan)[0], made.cells());
}

TEST(E57, PointsMarkedAsInvalidAreNoReturns) {
    const Scan expected = makeScan(ScanShape{});
    const E57Cells cells = e57CellsOf(expected, 2);
    std::vector<double> marks(cells.points.size(), 0);
    E57Cells with = cells;
    std::size_t marked = 0;
    for (std::size_t n = 0; n < marks.size(); n += 7, ++marked) {
        marks[n] = 1 + static_cast<double>(marked % 2); // a direction, or no information
        with.points[n] = {1, 1, 1};
    }
    E57Part part{e57Cartesian(with.points), e57Bounds(expected)};
    part.columns.push_back(e57Whole("cartesianInvalidState", marks));
    part.columns.push_back(e57Whole("rowIndex", cells.beams));
    part.columns.push_back(e57Whole("columnIndex", cells.lines));
    const auto scan = readBytes(e57Bytes({part}), ".e57");
    ASSERT_TRUE(scan) << scan.error().sentence();
    EXPECT_TRUE(e57Told(*scan, std::to_string(marked) + " points are marked as invalid"));
    for (std::size_t n = 0; n < marks.size(); ++n) {
        const auto state = scan->state.at(static_cast<int>(cells.lines[n]), static_cast<int>(cells.beams[n]));
        EXPECT_EQ(state, marks[n] != 0 ? CellState::NoReturn : CellState::Valid);
    }
}

TEST(E57, OfSeveralReturnsInACellTheNearestStaysAndTheRestIsCounted) {
    const Scan expected = makeScan(ScanShape{});
    E57Cells cells = e57CellsOf(expected, 2);
    for (std::size_t n = 0; n < 25; ++n) { // a second return on the same beams, twice as far
        cells.points.push_back(cells.points[n] * 2);
        cells.lines.push_back(cells.lines[n]);
        cells.beams.push_back(cells.beams[n]);
    }
    E57Part part{e57Cartesian(cells.points), e57Bounds(expected)};
    part.columns.push_back(e57Whole("rowIndex", cells.beams));
    part.columns.push_back(e57Whole("columnIndex", cells.lines));
    const auto scan = readBytes(e57Bytes({part}), ".e57");
    ASSERT_TRUE(scan) << scan.error().sentence();
    EXPECT_EQ(scan->rangeMm, expected.rangeMm);
    EXPECT_TRUE(e57Told(*scan, "25 points share their row and column"));
}

TEST(E57, OneOfSeveralScansIsOpenedWithItsPlace) {
    const Scan first = makeScan(ScanShape{});
    const Scan second = makeScan({.lines = 25, .beams = 33, .seed = 2});
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()));
    char pose[512];
    std::snprintf(pose, sizeof pose,
                  "<name type=\"String\">north wall</name><sensorModel type=\"String\">X7</sensorModel><pose type=\"Structure\"><rotation "
                  "type=\"Structure\"><w type=\"Float\">%.17g</w><x type=\"Float\">%.17g</x><y type=\"Float\">%.17g</y><z "
                  "type=\"Float\">%.17g</z></rotation><translation type=\"Structure\"><x type=\"Float\">512000.25</x><y "
                  "type=\"Float\">6.2000005e6</y><z type=\"Float\">300.125</z></translation></pose>",
                  turn.w(), turn.x(), turn.y(), turn.z());
    const auto part = [](const Scan& scan, const std::string& xml) {
        const E57Cells cells = e57CellsOf(scan, 1);
        E57Part made{e57Cartesian(cells.points), xml + e57Bounds(scan)};
        made.columns.push_back(e57Whole("rowIndex", cells.beams));
        made.columns.push_back(e57Whole("columnIndex", cells.lines));
        made.columns.push_back(e57Whole("intensity", cells.lines));
        made.columns.push_back(e57Whole("colorRed", cells.beams));
        return made;
    };
    const std::string both = e57Bytes({part(first, ""), part(second, pose)});
    const auto opened = readBytes(both, ".e57");
    ASSERT_TRUE(opened) << opened.error().sentence();
    EXPECT_EQ(opened->rangeMm, first.rangeMm);
    EXPECT_FALSE(opened->placement);
    EXPECT_TRUE(e57Told(*opened, "holds 2 scans; this is number 1, --scan chooses another"));
    EXPECT_TRUE(e57Told(*opened, "is not read: colorRed."));
    ASSERT_EQ(opened->intensity.size(), opened->cells());
    for (int line = 0; line < opened->lines(); ++line) {
        for (int beam = 0; beam < opened->beams(); ++beam) {
            if (opened->state.at(line, beam) == CellState::Valid) {
                ASSERT_EQ(opened->intensity.at(line, beam), static_cast<float>(line));
            }
        }
    }
    ReadingOptions options;
    options.scanIndex = 1;
    const auto other = readBytes(both, ".e57", options);
    ASSERT_TRUE(other) << other.error().sentence();
    EXPECT_EQ(other->rangeMm, second.rangeMm);
    EXPECT_EQ(other->note, "north wall");
    ASSERT_TRUE(other->acquisition);
    EXPECT_EQ(other->acquisition->model, "X7");
    ASSERT_TRUE(other->placement);
    EXPECT_EQ(other->placement->originEnhM + other->placement->poses[0].translationM, Eigen::Vector3d(512000.25, 6200000.5, 300.125));
    EXPECT_LT((other->placement->poses[0].rotation - turn.toRotationMatrix()).cwiseAbs().maxCoeff(), 1e-15);
    options.scanIndex = 2;
    EXPECT_NE(refusalOf(both, ".e57", options).find("--scan 2: the file holds 2 scans; use --scan 0 to 1."), std::string::npos);
}

TEST(E57, ListsGoTheWayOfOtherLists) {
    const Scan expected = makeScan(ScanShape{.beamStart = 20});
    E57Cells cells = e57CellsOf(expected, 6);
    const auto scan = readBytes(e57Bytes({{e57Cartesian(cells.points), ""}}), ".e57");
    ASSERT_TRUE(scan) << scan.error().sentence();
    EXPECT_LT(farthestFrom(expected, *scan), 1e-6); // in another order
    EXPECT_EQ(scan->cells(), expected.cells());
    // Indexes that do not form a grid are reported and ignored.
    E57Part wild{e57Cartesian(cells.points), ""};
    for (double& line : cells.lines) line *= 1e9;
    wild.columns.push_back(e57Whole("rowIndex", cells.beams));
    wild.columns.push_back(e57Whole("columnIndex", cells.lines));
    const auto again = readBytes(e57Bytes({wild}), ".e57");
    ASSERT_TRUE(again) << again.error().sentence();
    EXPECT_EQ(again->rangeMm, scan->rangeMm);
    EXPECT_TRUE(e57Told(*again, "make no grid"));
}

TEST(E57, DamageIsNamedByItsPage) {
    const E57Cells cells = e57CellsOf(makeScan(ScanShape{}), 1);
    const std::string good = e57Bytes({{e57Cartesian(cells.points), ""}});
    const std::size_t pages = good.size() / 1024;
    ASSERT_GT(pages, 20U);
    std::string bad = good;
    bad[7 * 1024 + 300] ^= 4;
    EXPECT_NE(refusalOf(bad, ".e57").find("byte 7168: page 8 of " + std::to_string(pages) + " of this E57 file is damaged"),
              std::string::npos);
    bad = good;
    bad[1023] ^= 1; // the checksum itself
    EXPECT_NE(refusalOf(bad, ".e57").find("page 1 of"), std::string::npos);
    EXPECT_NE(refusalOf(good.substr(0, good.size() - 1), ".e57").find("promises " + std::to_string(good.size()) + " bytes"),
              std::string::npos);
    EXPECT_NE(refusalOf(good.substr(0, 40), ".e57").find("ends within its E57 header"), std::string::npos);
}

TEST(E57, LiesAreRefusedBeforeAllocating) {
    const E57Cells cells = e57CellsOf(makeScan(ScanShape{}), 1);
    E57Part part{e57Cartesian(cells.points), ""};
    part.promised = cells.points.size() + 1;
    EXPECT_NE(refusalOf(e57Bytes({part}), ".e57").find("the column cartesianX ends after " + std::to_string(cells.points.size())),
              std::string::npos);
    part.promised = std::uint64_t{1} << 60U;
    EXPECT_NE(refusalOf(e57Bytes({part}), ".e57").find("promises 1152921504606846976 points"), std::string::npos);
    part.promised = 0;
    EXPECT_NE(refusalOf(e57Bytes({part}), ".e57").find("scan 1 of this E57 file holds no points"), std::string::npos);
    // Equal numbers take no bytes at all.
    E57Part same{e57Cartesian({{1, 1, 1}}), ""};
    for (E57Column& column : same.columns) {
        column = e57Whole(column.name, {1});
        column.minimum = column.maximum = 1;
    }
    same.promised = std::uint64_t{1} << 40U;
    EXPECT_NE(refusalOf(e57Bytes({same}), ".e57").find("promises 1099511627776 points"), std::string::npos);
    E57Part colours{{e57Whole("colorRed", {1, 2, 3})}, ""};
    EXPECT_NE(refusalOf(e57Bytes({colours}), ".e57").find("neither cartesian nor spherical coordinates, only colorRed"), std::string::npos);
    std::string kind = e57Bytes({{e57Cartesian(cells.points), ""}});
    kind[48 + 32] = 9;
    EXPECT_NE(refusalOf(withE57Checksums(kind), ".e57").find("byte 80: a packet of points is of kind 9"), std::string::npos);
}

TEST(E57, FilesOfOtherPrograms) {
    EDGESCAN_NEEDS_SHARED("data/e57");
    const auto pointsOf = [](const std::string& name) {
        const std::string bytes = sharedE57(name);
        const ReadingOptions options;
        const Source source{name, std::as_bytes(std::span(bytes)), &options, true};
        auto reading = formatOfContent(source).read(source);
        return reading ? pointsAsWritten(std::move(*reading)) : std::vector<Eigen::Vector3d>{};
    };
    const auto doubles = pointsOf("bunnyDouble.e57");
    const auto wholes = pointsOf("bunnyInt32.e57");
    ASSERT_EQ(doubles.size(), 30571U);
    ASSERT_EQ(wholes.size(), 30571U);
    Eigen::AlignedBox3d box;
    for (std::size_t n = 0; n < doubles.size(); ++n) {
        EXPECT_LT((doubles[n] - wholes[n]).cwiseAbs().maxCoeff(), 0.51e-6) << n;
        box.extend(doubles[n]);
    }
    // As given in the file's own XML part.
    EXPECT_EQ(box.min(), Eigen::Vector3d(-0.094689, 0.040010999999999998, -0.061872999999999997));
    EXPECT_EQ(box.max(), Eigen::Vector3d(0.061008999999999994, 0.18732099999999999, 0.058798999999999997));
    const auto cube = pointsOf("ColouredCubeFloat.e57");
    ASSERT_EQ(cube.size(), 7680U);
    for (const auto& p : cube) EXPECT_EQ(p.cwiseAbs().maxCoeff(), 0.5);
    EXPECT_EQ(pointsOf("testWithNormals.e57"), (std::vector<Eigen::Vector3d>{{1, 0, 0}, {2, 0, 0}}));
    const auto moved = pointsOf("translationWithoutRotation.e57");
    ASSERT_EQ(moved.size(), 3U); // of four; the fourth is at the scanner itself: a beam without a return
    Eigen::AlignedBox3d place;
    for (const auto& p : moved) place.extend(p);
    EXPECT_EQ(place.min(), Eigen::Vector3d(4, 5, 6));
    EXPECT_EQ(place.max(), Eigen::Vector3d(5, 6, 6));
    for (const char* name : {"bunnyDouble.e57", "bunnyInt32.e57"}) {
        const auto scan = readBytes(sharedE57(name), ".e57");
        ASSERT_TRUE(scan) << scan.error().sentence();
        EXPECT_EQ(countCells(*scan)[0] + scan->attached.size(), 30571U);
    }
    struct Refusal {
        const char* name;
        const char* says;
    };
    for (const Refusal& refusal : {Refusal{"ZeroPoints.e57", "scan 1 of this E57 file holds no points"},
                                   {"ZeroPointsInvalid.e57", "scan 1 of this E57 file holds no points"},
                                   {"InvalidCVHeader.e57", "scan 1 of this E57 file holds no points"},
                                   {"empty.e57", "this E57 file holds no scan"},
                                   {"bad-crc.e57", "byte 0: page 1 of 1 of this E57 file is damaged"},
                                   {"testWithNormals.e57", "2 points"},
                                   {"translationWithoutRotation.e57", "3 points"}}) {
        const std::string sentence = refusalOf(sharedE57(refusal.name), ".e57");
        EXPECT_NE(sentence.find(refusal.says), std::string::npos) << refusal.name << ": " << sentence;
    }
}
