// numpy arrays: ranges and points in every byte order and index order, archives of them, and refusals.
#include "tests/support/bytes.h"
#include "tests/support/packed_files.h"
#include "tests/support/point_lists.h"
#include "tests/support/typed_angles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

using namespace edgescan;
using namespace edgescan::files;
using namespace edgescan::test;

namespace {

bool numpyTold(const Scan& scan, const std::string& part) {
    return std::ranges::any_of(scan.warnings, [&](const std::string& w) { return w.find(part) != std::string::npos; });
}

std::vector<double> rangesOf(const Scan& scan, double perMm) {
    std::vector<double> values;
    for (std::size_t k = 0; k < scan.cells(); ++k)
        values.push_back(scan.state[k] == CellState::Valid ? static_cast<double>(scan.rangeMm[k]) * perMm : 0.0);
    return values;
}

std::string shapeOf(const Scan& scan) { return "(" + std::to_string(scan.lines()) + ", " + std::to_string(scan.beams()) + ")"; }

} // namespace

TEST(Numpy, RangesInEveryTypeAndOrder) {
    const Scan expected = makeScan(ScanShape{});
    const auto sides = std::pair<std::size_t, std::size_t>(expected.lines(), expected.beams());
    for (const bool fortran : {false, true}) {
        for (const bool big : {false, true}) {
            for (const char* type : {"f4", "f8", "i4", "u2", "i8", "u4", "f8 m", "f4 m"}) {
                SCOPED_TRACE(std::string(type) + (fortran ? " Fortran" : " C") + (big ? " big" : " little"));
                const bool metres = std::string(type).ends_with("m");
                const std::string name = (big ? ">" : "<") + std::string(type).substr(0, 2);
                const std::string bytes =
                    npyBytes(npyHeader("'" + name + "'", fortran, shapeOf(expected)),
                             npyData(rangesOf(expected, metres ? 0.001 : 1.0), name, fortran ? std::optional(sides) : std::nullopt));
                const auto scan = readBytes(bytes, ".npy", typedAngles(expected));
                ASSERT_TRUE(scan) << scan.error().sentence();
                EXPECT_EQ(scan->rangeMm, expected.rangeMm);
                EXPECT_EQ(scan->state, expected.state);
                EXPECT_TRUE(numpyTold(*scan, metres ? "Unit taken as metres" : "Unit taken as millimetres"));
            }
        }
    }
}

TEST(Numpy, WhatIsNoRangeIsNoReturn) {
    const double inf = std::numeric_limits<double>::infinity();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    std::vector<double> values(2 * 20, 1500);
    values[3] = nan;
    values[4] = inf;
    values[5] = 0;
    values[6] = -1;
    values[7] = -1;
    ReadingOptions options = typedAngles(makeScan(ScanShape{}));
    const auto made = [&](const std::vector<double>& numbers) {
        return npyBytes(npyHeader("'<f8'", false, "(2, 20)"), npyData(numbers, "<f8"));
    };
    const auto scan = readBytes(made(values), ".npy", options);
    ASSERT_TRUE(scan) << scan.error().sentence();
    EXPECT_EQ(countCells(*scan)[0], 35U);
    EXPECT_TRUE(numpyTold(*scan, "1 infinite ranges"));
    EXPECT_TRUE(numpyTold(*scan, "2 ranges below 0"));
    values[8] = -2;
    EXPECT_NE(refusalOf(made(values), ".npy", options).find("at [0, 8]"), std::string::npos);
    EXPECT_NE(refusalOf(made(values), ".npy").find("does not say its angles"), std::string::npos);
}

TEST(Numpy, PointsAsListsGridsAndRecords) {
    const Scan expected = makeScan(ScanShape{.beamStart = 20});
    const auto points = listOf(expected, {});
    std::vector<double> three, four;
    for (const auto& p : points) {
        three.insert(three.end(), {p.x(), p.y(), p.z()});
        four.insert(four.end(), {p.x(), p.y(), p.z(), 0.5});
    }
    const std::string n = std::to_string(points.size());
    const std::string grid = "(" + std::to_string(expected.lines()) + ", " + std::to_string(expected.beams());
    const std::string data = npyData(three, "<f4");
    const std::string record = "[('x', '<f4'), ('y', '<f4'), ('z', '<f4')]";
    for (const std::string& bytes :
         {npyBytes(npyHeader("'<f4'", false, "(" + n + ", 3)"), data), npyBytes(npyHeader("'<f4'", false, grid + ", 3)"), data),
          npyBytes(npyHeader("'<f4'", false, "(" + n + ", 4)"), npyData(four, "<f4")),
          npyBytes(npyHeader(record, false, "(" + n + ",)"), data), npyBytes(npyHeader(record, false, grid + ")"), data)}) {
        const auto scan = readBytes(bytes, ".npy");
        ASSERT_TRUE(scan) << scan.error().sentence();
        EXPECT_EQ(scan->rangeMm, expected.rangeMm) << bytes.substr(0, 80);
        EXPECT_EQ(scan->state, expected.state);
    }
}

TEST(Numpy, ArchivesAreRefusedByName) {
    const std::string array = npyBytes(npyHeader("'<f8'", false, "(3,)"), npyData({1, 2, 3}, "<f8"));
    EXPECT_NE(refusalOf(zipBytes({{"arr_0.npy", array}}, true), ".npz").find("a numpy archive, which is not read; save the array"),
              std::string::npos);
    EXPECT_NE(refusalOf(zipBytes({{"readme.txt", "hello"}}, true), ".zip").find("a ZIP archive"), std::string::npos);
}

TEST(Numpy, WhatIsNoScanIsRefusedWithASentence) {
    const auto refused = [](const std::string& type, const std::string& shape, const std::string& data) {
        return refusalOf(npyBytes(npyHeader(type, false, shape), data), ".npy");
    };
    EXPECT_NE(refused("'|O'", "(3, 40)", "xxxx").find("Python objects"), std::string::npos);
    EXPECT_NE(refused("'<c16'", "(3, 40)", "xxxx").find("complex numbers"), std::string::npos);
    EXPECT_NE(refused("'<f8'", "(1000000, 1000000)", "xxxx").find("promises an array of shape (1000000, 1000000)"), std::string::npos);
    EXPECT_NE(refused("'<f8'", "(4294967296, 4294967296)", "xxxx").find("promises an array of shape"), std::string::npos);
    EXPECT_NE(refused("'<f8'", "(100, 100)", "xxxx").find("10000 items of 8 bytes, and the file holds 4 bytes"), std::string::npos);
    EXPECT_NE(refused("'<f8'", "(0, 100)", "").find("is empty"), std::string::npos);
    EXPECT_NE(refused("'<f8'", "(7,)", std::string(56, 'x')).find("shape (7,) is neither ranges"), std::string::npos);
    EXPECT_NE(refused("'<f8'", "(3, 40)", std::string(960, 'x')).find("points the wrong way round"), std::string::npos);
    EXPECT_NE(refused("[('a', '<f4')]", "(7,)", std::string(28, 'x')).find("have no x, y and z, only a"), std::string::npos);
    EXPECT_NE(refusalOf("\x93NUMPY\x01", ".npy").find("ends within its numpy header"), std::string::npos);
    EXPECT_NE(refusalOf(npyBytes("{'descr': __import__('os')}", ""), ".npy").find("does not say type, order and shape"), std::string::npos);
}
