// PTX: the grid as scanned, several scans in one file, and faults of files.
#include "core/files/open_save/save_scan.h"
#include "core/scan/grid/placement.h"
#include "tests/support/bytes.h"
#include "tests/support/point_lists.h"

#include <gtest/gtest.h>

#include <numeric>
#include <sstream>

using namespace edgescan;
using namespace edgescan::files;
using namespace edgescan::test;

namespace {

/// As a scanner's program writes it.
std::string ptxOf(const Scan& scan, const char* format = "%.6f", const std::string& place = "0 0 0") {
    std::string text = std::to_string(scan.lines()) + "\r\n" + std::to_string(scan.beams()) + "\r\n" + place +
                       "\r\n1 0 0\r\n0 1 0\r\n0 0 1\r\n1 0 0 0\r\n0 1 0 0\r\n0 0 1 0\r\n" + place + " 1\r\n";
    for (const auto& p : listOf(scan, {})) {
        for (int a = 0; a < 3; ++a) text += numberText(format, p[a]) + " ";
        text += "0.25 10 20 30\r\n";
    }
    return text;
}

/// A simple reading of the numbers.
std::vector<Eigen::Vector3d> lookInto(const std::string& text, int& columns, int& rows) {
    std::istringstream in(text);
    double skipped = 0;
    in >> columns >> rows;
    for (int i = 0; i < 28; ++i) in >> skipped;
    std::vector<Eigen::Vector3d> points;
    Eigen::Vector3d p;
    while (in >> p.x() >> p.y() >> p.z() >> skipped) points.push_back(p);
    return points;
}

} // namespace

TEST(Ptx, ScannersFilesOpenAsTheirGrid) {
    for (const Axis axis : {Axis::Spin, Axis::Sweep}) {
        for (const char* format : {"%.6f", "%.4f"}) {
            ScanShape shape;
            shape.axis = axis;
            shape.beamStart = axis == Axis::Sweep ? 20 : -15;
            const Scan expected = makeScan(shape);
            const auto scan = readBytes(ptxOf(expected, format), ".ptx");
            ASSERT_TRUE(scan) << scan.error().sentence();
            EXPECT_EQ(scan->format, "PTX");
            EXPECT_EQ(scan->rangeMm, expected.rangeMm);
            EXPECT_EQ(scan->state, expected.state);
            EXPECT_EQ(std::get<PolarGeometry>(scan->geometry), std::get<PolarGeometry>(expected.geometry));
        }
    }
}

TEST(Ptx, SavedScansComeBackWithEveryCell) {
    const Folder folder;
    for (unsigned seed = 1; seed <= 5; ++seed) {
        const Scan scan = makeScan({.lines = 20 + int(seed), .beams = 31, .noReturns = 0.1 * seed, .seed = seed});
        ASSERT_TRUE(saveScan(scan, folder / "scan.ptx"));
        int columns = 0;
        int rows = 0;
        const auto points = lookInto(readText(folder / "scan.ptx"), columns, rows);
        EXPECT_EQ(columns, scan.lines());
        EXPECT_EQ(rows, scan.beams());
        EXPECT_EQ(points.size(), scan.cells());
        const auto back = openScan(folder / "scan.ptx");
        ASSERT_TRUE(back) << back.error().sentence();
        EXPECT_EQ(back->rangeMm, scan.rangeMm);
        EXPECT_EQ(back->state, scan.state);
        const auto counts = countCells(*back);
        EXPECT_EQ(std::accumulate(counts.begin(), counts.end(), std::size_t{0}), scan.cells());
    }
}

TEST(Ptx, EdgesAloneKeepTheGrid) {
    const Scan scan = makeScan({});
    Grid<std::uint8_t> mask(scan.lines(), scan.beams());
    for (std::size_t k = 0; k < mask.size(); k += 4) mask[k] = 255;
    const auto bytes = edgeBytes(scan, mask, "edges.ptx");
    ASSERT_TRUE(bytes) << bytes.error().sentence();
    int columns = 0;
    int rows = 0;
    const auto points = lookInto(*bytes, columns, rows);
    ASSERT_EQ(points.size(), scan.cells());
    for (std::size_t k = 0; k < points.size(); ++k) EXPECT_EQ(points[k].isZero(0), !(mask[k] != 0 && scan.state[k] == CellState::Valid));
}

TEST(Ptx, OneOfSeveralScansIsOpenedAndReported) {
    const Scan first = makeScan({.seed = 1});
    const Scan second = makeScan({.lines = 25, .beams = 33, .seed = 2});
    const std::string both = ptxOf(first) + ptxOf(second, "%.6f", "512000.25 6200000.5 300.125") + "\r\n";
    const auto opened = readBytes(both, ".ptx");
    ASSERT_TRUE(opened) << opened.error().sentence();
    EXPECT_EQ(opened->rangeMm, first.rangeMm);
    const auto told = [](const Scan& scan, const std::string& part) {
        return std::any_of(scan.warnings.begin(), scan.warnings.end(), [&](const auto& w) { return w.find(part) != std::string::npos; });
    };
    EXPECT_TRUE(told(*opened, "holds 2 scans; this is number 1"));
    ReadingOptions options;
    options.scanIndex = 1;
    const auto other = readBytes(both, ".ptx", options);
    ASSERT_TRUE(other) << other.error().sentence();
    EXPECT_EQ(other->rangeMm, second.rangeMm);
    ASSERT_TRUE(other->placement);
    EXPECT_EQ(other->placement->originEnhM + other->placement->poses[0].translationM, Eigen::Vector3d(512000.25, 6200000.5, 300.125));
    options.scanIndex = 2;
    EXPECT_NE(refusalOf(both, ".ptx", options).find("--scan 2: the file holds 2 scans; use --scan 0 to 1."), std::string::npos);
    // A truncated second scan does not affect the first.
    EXPECT_TRUE(readBytes(both.substr(0, both.size() - 500), ".ptx"));
    options.scanIndex = 1;
    EXPECT_NE(refusalOf(both.substr(0, both.size() - 500), ".ptx", options).find("scan 2 of this PTX file promises 25 columns"),
              std::string::npos);
}

TEST(Ptx, LyingHeadersAreRefusedBeforeAllocating) {
    const std::string body = ptxOf(makeScan({.lines = 5, .beams = 9}));
    const auto with = [&](const std::string& columns, const std::string& rows) {
        return refusalOf(columns + "\r\n" + rows + body.substr(body.find("\r\n", body.find("\r\n") + 2)), ".ptx");
    };
    for (const auto& [columns, rows] : {std::pair("1000000000", "1000000000"), std::pair("4000000000", "4000000000"), std::pair("6", "9"),
                                        std::pair("0", "9"), std::pair("18446744073709551615", "2")})
        EXPECT_NE(with(columns, rows).find("the file ends before them"), std::string::npos) << with(columns, rows);
}
