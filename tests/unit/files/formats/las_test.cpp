// LAS input and output, compared with a small independent reader written from the ASPRS specification.
#include "core/base/whole_file.h"
#include "core/files/open_save/save_scan.h"
#include "tests/support/bytes.h"
#include "tests/support/placements.h"
#include "tests/support/point_lists.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numeric>

using namespace edgescan;
using namespace edgescan::files;
using namespace edgescan::test;

namespace {

/// The values that any LAS 1.4 program reads.
struct Seen {
    std::vector<Eigen::Vector3d> points;
    std::vector<std::string> extraNames;
    std::string system;
    std::vector<unsigned> classes, green;
    std::vector<std::array<double, 4>> extras; ///< line, beam, range_mm, last
    Eigen::Vector3d least, most, offset;
};
Seen lookInto(const std::string& las) {
    Seen seen;
    EXPECT_EQ(las.substr(0, 4), "LASF");
    EXPECT_EQ(las[24], 1);
    EXPECT_EQ(las[25], 4);
    EXPECT_EQ(valueAt<std::uint16_t>(las, 94), 375);
    EXPECT_TRUE(las[104] == 6 || las[104] == 7);
    const std::size_t own = las[104] == 7 ? 36 : 30; // bytes of the standard record
    const auto record = valueAt<std::uint16_t>(las, 105);
    const auto count = valueAt<std::uint64_t>(las, 247);
    EXPECT_EQ(valueAt<std::uint64_t>(las, 255), count); // first returns
    EXPECT_EQ(valueAt<std::uint32_t>(las, 107), 0U);    // formats from 6 on leave the old count 0
    std::size_t at = 375;
    for (std::uint32_t n = 0; n < valueAt<std::uint32_t>(las, 100); ++n) {
        const auto length = valueAt<std::uint16_t>(las, at + 20);
        if (std::string(las.data() + at + 2) == "LASF_Projection") {
            EXPECT_EQ(valueAt<std::uint16_t>(las, at + 18), 2112);
            seen.system = las.data() + at + 54;
            at += 54U + length;
            continue;
        }
        EXPECT_EQ(std::string(las.data() + at + 2), "LASF_Spec");
        EXPECT_EQ(valueAt<std::uint16_t>(las, at + 18), 4);
        for (std::size_t e = 0; e < length; e += 192) seen.extraNames.emplace_back(las.data() + at + 54 + e + 4);
        at += 54U + length;
    }
    EXPECT_EQ(valueAt<std::uint32_t>(las, 96), at);
    for (int a = 0; a < 3; ++a) {
        const auto i = static_cast<std::size_t>(a);
        seen.offset[a] = valueAt<double>(las, 155 + 8 * i);
        seen.most[a] = valueAt<double>(las, 179 + 16 * i);
        seen.least[a] = valueAt<double>(las, 187 + 16 * i);
    }
    for (std::uint64_t n = 0; n < count; ++n, at += record) {
        Eigen::Vector3d p;
        for (int a = 0; a < 3; ++a) {
            const auto i = static_cast<std::size_t>(a);
            p[a] = valueAt<std::int32_t>(las, at + 4 * i) * valueAt<double>(las, 131 + 8 * i) + seen.offset[a];
        }
        seen.points.push_back(p);
        seen.classes.push_back(static_cast<unsigned char>(las[at + 16]));
        if (own == 36) seen.green.push_back(valueAt<std::uint16_t>(las, at + 32));
        seen.extras.push_back({double(valueAt<std::uint32_t>(las, at + own)), double(valueAt<std::uint32_t>(las, at + own + 4)),
                               double(valueAt<float>(las, at + own + 8)), double(static_cast<unsigned char>(las[at + own + 12]))});
    }
    EXPECT_LE(at, las.size());
    return seen;
}

/// A LAS file as old programs write it.
std::string oldLas(const std::vector<Eigen::Vector3d>& points, int minor, unsigned format, double scale, const Eigen::Vector3d& offset) {
    static constexpr std::array<std::uint16_t, 11> kBytes{20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};
    const std::size_t header = minor == 4 ? 375 : minor == 3 ? 235 : 227;
    std::string las(header + 2, '\0'); // two bytes of padding before the points, as LAS 1.0 has
    las.replace(0, 4, "LASF");
    las[24] = 1;
    las[25] = static_cast<char>(minor);
    putAt(las, 94, static_cast<std::uint16_t>(header));
    putAt(las, 96, static_cast<std::uint32_t>(header + 2));
    las[104] = static_cast<char>(format);
    const auto record = static_cast<std::uint16_t>(kBytes[format] + 3);
    putAt(las, 105, record);
    putAt(las, format > 5 ? 247U : 107U, static_cast<std::uint32_t>(points.size()));
    for (std::size_t a = 0; a < 3; ++a) {
        putAt(las, 131 + 8 * a, scale);
        putAt(las, 155 + 8 * a, offset[static_cast<Eigen::Index>(a)]);
    }
    for (const auto& p : points) {
        std::string one(record, '\x5A');
        for (std::size_t a = 0; a < 3; ++a) {
            const auto i = static_cast<Eigen::Index>(a);
            putAt(one, 4 * a, static_cast<std::int32_t>(std::llround((p[i] - offset[i]) / scale)));
        }
        las += one;
    }
    return las;
}

} // namespace

TEST(Las, WholeScansComeBackExactlyWithEveryState) {
    const Folder folder;
    for (unsigned seed = 1; seed <= 6; ++seed) {
        Scan scan = makeScan({.lines = 17, .beams = 23, .motorJitter = 0.4, .fraction = 1, .seed = seed});
        std::mt19937 random(seed);
        for (std::size_t k = 0; k < scan.cells(); ++k) {
            if (random() % 3 == 0) scan.state[k] = static_cast<CellState>(random() % kCellStates);
            if (scan.state[k] == CellState::Valid && !(scan.rangeMm[k] > 0)) scan.rangeMm[k] = 1500;
        }
        ASSERT_TRUE(saveScan(scan, folder / "scan.las"));
        const auto back = openScan(folder / "scan.las");
        ASSERT_TRUE(back) << back.error().sentence();
        EXPECT_EQ(back->rangeMm, scan.rangeMm);
        EXPECT_EQ(back->state, scan.state);
        EXPECT_EQ(std::get<PolarGeometry>(back->geometry), std::get<PolarGeometry>(scan.geometry));
        const auto counts = countCells(*back);
        EXPECT_EQ(std::accumulate(counts.begin(), counts.end(), std::size_t{0}), scan.cells());
        EXPECT_EQ(lookInto(readText(folder / "scan.las")).points.size(), counts[0]);
    }
}

TEST(Las, CloudsAreSeenByAnIndependentReader) {
    const Scan scan = makeScan({});
    Grid<std::uint8_t> mask(scan.lines(), scan.beams());
    for (std::size_t k = 0; k < mask.size(); k += 5) mask[k] = 255;
    const auto bytes = cloudBytes(scan, "cloud.las", &mask);
    ASSERT_TRUE(bytes) << bytes.error().sentence();
    const Seen seen = lookInto(*bytes);
    EXPECT_EQ(seen.extraNames, (std::vector<std::string>{"line", "beam", "range_mm", "edge"}));
    const CartesianTables tables(scan);
    std::size_t n = 0;
    for (std::size_t k = 0; k < scan.cells(); ++k) {
        if (scan.state[k] != CellState::Valid) continue;
        ASSERT_LT(n, seen.points.size());
        EXPECT_LE((seen.points[n] - tables.point(k)).cwiseAbs().maxCoeff(), 0.000501);
        EXPECT_EQ(seen.extras[n][0] * scan.beams() + seen.extras[n][1], static_cast<double>(k));
        EXPECT_EQ(seen.extras[n][2], scan.rangeMm[k]);
        EXPECT_EQ(seen.extras[n][3], mask[k]);
        EXPECT_TRUE((seen.points[n].array() >= seen.least.array() - 0.001).all() &&
                    (seen.points[n].array() <= seen.most.array() + 0.001).all());
        ++n;
    }
    EXPECT_EQ(n, seen.points.size());
    EXPECT_TRUE(seen.offset.isZero());
}

TEST(Las, MineCoordinatesKeepTheirMillimetresThroughTheOffset) {
    Scan scan = makeScan({});
    PointGeometry geometry{Grid<Eigen::Vector3d>(scan.lines(), scan.beams(), Eigen::Vector3d::Zero()),
                           Eigen::Vector3d(512000, 6200000, 300)};
    const CartesianTables tables(scan);
    for (std::size_t k = 0; k < scan.cells(); ++k) geometry.pointsM[k] = geometry.sensorM + tables.point(k);
    scan.geometry = geometry;
    const auto bytes = cloudBytes(scan, "cloud.las", nullptr);
    ASSERT_TRUE(bytes) << bytes.error().sentence();
    const Seen seen = lookInto(*bytes);
    EXPECT_GT(seen.offset.y(), 6.19e6);
    std::size_t n = 0;
    for (std::size_t k = 0; k < scan.cells(); ++k) {
        if (scan.state[k] == CellState::Valid) {
            EXPECT_LE((seen.points[n++] - geometry.pointsM[k]).cwiseAbs().maxCoeff(), 0.000501);
        }
    }
}

TEST(Las, ZoneAndDatumOfAPoseAreTheCoordinateSystem) {
    const std::vector<std::pair<const char*, const char*>> grids{{"17N, WGS84", "32617"},
                                                                 {"17S, WGS 84", "32717"},
                                                                 {"UTM 5N, WGS84", "32605"},
                                                                 {"WGS 84 / UTM zone 60S", "32760"},
                                                                 {"EPSG:32617", "32617"},
                                                                 {"17N", ""},
                                                                 {"17N, NAD83", ""},
                                                                 {"61N, WGS84", ""},
                                                                 {"17 South Street, WGS84", ""},
                                                                 {"Level 17N, WGS84", ""},
                                                                 {"", ""}};
    for (const auto& [grid, code] : grids) {
        Scan scan = makeScan({.lines = 5, .beams = 6});
        Placement placement = *randomPlacement(2, 1, false);
        placement.grid = grid;
        scan.placement = std::make_shared<const Placement>(placement);
        const auto bytes = cloudBytes(scan, "a.las", nullptr, {.frame = CoordinateFrame::Mine});
        ASSERT_TRUE(bytes) << bytes.error().sentence();
        const std::string epsg = std::string("AUTHORITY[\"EPSG\",\"") + code + "\"]]";
        EXPECT_EQ(bytes->find(*code != 0 ? epsg : std::string("LOCAL_CS[")) != std::string::npos, true) << grid;
        const auto local = cloudBytes(scan, "a.las", nullptr, {.frame = CoordinateFrame::MineLocal});
        EXPECT_NE(local->find("LOCAL_CS["), std::string::npos) << grid;
    }
}

TEST(Las, EveryVersionAndPointFormatOpensAsItsGrid) {
    const Scan expected = makeScan({.noReturns = 0});
    const auto points = listOf(expected, {});
    for (const int minor : {0, 1, 2, 3, 4}) {
        for (unsigned format = 0; format <= (minor == 4 ? 10U : minor == 3 ? 5U : 3U); ++format) {
            SCOPED_TRACE("1." + std::to_string(minor) + " format " + std::to_string(format));
            const auto scan = readBytes(oldLas(points, minor, format, 0.0001, Eigen::Vector3d(10, -20, 5)), ".las");
            ASSERT_TRUE(scan) << scan.error().sentence();
            EXPECT_EQ(scan->format, "LAS");
            EXPECT_EQ(scan->rangeMm, expected.rangeMm);
        }
    }
}

// Version 1.0 has no such bit: classes of 128 and more are private.
TEST(Las, PointsMarkedAsDeletedAreNoReturnsAndReported) {
    const Scan whole = makeScan({.noReturns = 0});
    const auto points = listOf(whole, {});
    for (const auto& [minor, format, bit] :
         {std::array{2U, 1U, 0x80U}, {1U, 0U, 0x80U}, {4U, 3U, 0x80U}, {4U, 6U, 0x04U}, {0U, 0U, 0x80U}}) {
        SCOPED_TRACE("1." + std::to_string(minor) + " format " + std::to_string(format));
        Scan expected = whole;
        std::string las = oldLas(points, static_cast<int>(minor), format, 0.0001, Eigen::Vector3d(10, -20, 5));
        const std::size_t first = (minor == 4 ? 375 : 227) + 2;
        const std::size_t record = (las.size() - first) / points.size();
        for (std::size_t n = 0; n < points.size(); n += 9) {
            las[first + n * record + 15] = static_cast<char>(static_cast<unsigned char>(las[first + n * record + 15]) | bit);
            if (minor == 0) continue;
            expected.rangeMm[n] = 0;
            expected.state[n] = CellState::NoReturn;
        }
        const auto scan = readBytes(las, ".las");
        ASSERT_TRUE(scan) << scan.error().sentence();
        EXPECT_EQ(scan->state, expected.state);
        EXPECT_EQ(std::ranges::any_of(scan->warnings, [&](const auto& w) { return w.find("points are marked as withheld") != w.npos; }),
                  minor != 0);
    }
}

TEST(Las, SentencesSayWhatIsWrong) {
    const auto points = listOf(makeScan({.noReturns = 0}), {});
    const std::string good = oldLas(points, 2, 1, 0.001, Eigen::Vector3d::Zero());
    const auto refused = [&](std::size_t at, auto value, const char* expected) {
        std::string bytes = good;
        putAt(bytes, at, value);
        const std::string sentence = refusalOf(bytes, ".las");
        EXPECT_NE(sentence.find(expected), std::string::npos) << sentence;
    };
    refused(107, std::uint32_t{4000000000U}, "promises 4000000000 points of 31 bytes and the file holds");
    refused(107, std::uint32_t{0}, "no points");
#ifdef EDGESCAN_WITH_LASZIP
    refused(104, std::uint8_t{0x81}, "this LAZ file is damaged or cut off"); // the header says so, but the content is not compressed
#else
    refused(104, std::uint8_t{0x81}, "compressed (LAZ)");
#endif
    refused(104, std::uint8_t{11}, "none that LAS knows");
    refused(105, std::uint16_t{5}, "none that LAS knows");
    refused(96, std::uint32_t{4000000000U}, "which is not in the file");
    refused(94, std::uint16_t{9}, "header says it is 9 bytes");
    refused(24, std::uint8_t{2}, "LAS version 2.2");
    refused(131, std::nan(""), "scale or offset");
    refused(131, 0.0, "scale or offset");
    refused(155, 1e300, "scale or offset");
    EXPECT_NE(refusalOf(good.substr(0, 100), ".las").find("ends within its LAS header"), std::string::npos);
}
