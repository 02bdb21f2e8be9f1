// Files that once crashed a reader, loaded garbage, or lost data without a warning.
#include "core/edges/pipeline/pipeline.h"
#include "core/files/open_save/open_scan.h"
#include "core/files/open_save/save_scan.h"
#include "core/scan/grid/cartesian.h"
#include "tests/support/run_program.h"
#include "tests/support/scans.h"

#include <gtest/gtest.h>

#include <cstring>
#include <sstream>

namespace edgescan::files {
namespace {

struct Hostile : public ::testing::Test {
    test::TemporaryFolder folder;

    std::filesystem::path written(const std::string& name, const std::string& content) const {
        std::ofstream(folder / name, std::ios::binary) << content;
        return folder / name;
    }
};

std::string pcdHeader(const std::string& fields, const std::string& counts, const std::string& viewpoint, int points,
                      const std::string& data) {
    std::ostringstream header;
    header << "VERSION 0.7\nFIELDS " << fields << "\nSIZE 4 4 4\nTYPE F F F\nCOUNT " << counts << "\nWIDTH " << points
           << "\nHEIGHT 1\nVIEWPOINT " << viewpoint << " 1 0 0 0\nPOINTS " << points << "\nDATA " << data << "\n";
    return header.str();
}

TEST_F(Hostile, AFieldWithoutNumbersIsRefused) {
    for (const char* data : {"binary", "ascii", "binary_compressed"}) {
        for (const auto& [fields, counts] : {std::pair{"x y z", "0 0 0"}, {"y z x", "1 1 0"}, {"x y z", "1 0 1"}}) {
            const auto path = written("count0.pcd", pcdHeader(fields, counts, "0 0 0", 100, data) + std::string(2000, '1'));
            const auto scan = openScan(path);
            ASSERT_FALSE(scan) << data << " " << counts;
            EXPECT_NE(scan.error().sentence().find("count0.pcd"), std::string::npos);
        }
    }
}

TEST_F(Hostile, AViewpointOffTheEarthIsIgnoredAndNoRangeIsInfinite) {
    std::string points;
    for (int n = 0; n < 400; ++n) {
        for (const float v : {static_cast<float>(n % 20) * 0.1F - 1.0F, static_cast<float>(n / 20) * 0.1F - 1.0F, 3.0F}) {
            points.append(reinterpret_cast<const char*>(&v), sizeof v);
        }
    }
    std::string header = pcdHeader("x y z", "1 1 1", "1e200 0 0", 400, "binary");
    header.replace(header.find("WIDTH 400\nHEIGHT 1"), std::strlen("WIDTH 400\nHEIGHT 1"), "WIDTH 20\nHEIGHT 20");
    const auto scan = openScan(written("far.pcd", header + points));
    ASSERT_TRUE(scan) << scan.error().sentence();
    EXPECT_EQ(countCells(*scan)[0], 400U);
    EXPECT_LT(rangeLimits(*scan).maxMm, 10000);
    EXPECT_NO_THROW((void)edges::detectEdges(std::make_shared<Scan>(*scan), edges::Settings{}));
}

TEST_F(Hostile, ARangeThatIsNoRangeIsRefusedInOurOwnFiles) {
    ASSERT_TRUE(saveScan(test::boxesScan(12, 15, 1), folder / "own.csv", {.choices = {.comments = true}}));
    std::string text = test::fileText(folder / "own.csv");
    const auto scan = openScan(folder / "own.csv");
    ASSERT_TRUE(scan);
    std::ostringstream range;
    range << static_cast<int>(scan->rangeMm[7]);
    // The range is near the last column: invert every occurrence of that number.
    for (std::size_t at = text.find("," + range.str() + ","); at != std::string::npos; at = text.find("," + range.str() + ",", at + 1)) {
        text.insert(at + 1, "-");
    }
    const auto bad = openScan(written("negative.csv", text));
    EXPECT_FALSE(bad);
}

TEST_F(Hostile, ColumnsBeforeTheCoordinatesDoNotSpoilTheirPrecision) {
    const Scan scan = test::boxesScan(24, 40, 5);
    const CartesianTables tables(scan);
    std::ostringstream text;
    text << "id,ring,intensity,x_m,y_m,z_m\n";
    text.precision(7);
    for (std::size_t k = 0; k < scan.cells(); ++k) {
        const Eigen::Vector3d p = tables.point(k);
        text << k << "," << k / 40 << ",7," << p.x() << "," << p.y() << "," << p.z() << "\n";
    }
    const auto back = openScan(written("columns.csv", text.str()));
    ASSERT_TRUE(back) << back.error().sentence();
    EXPECT_EQ(back->lines(), 24);
    EXPECT_EQ(back->beams(), 40);
}

TEST_F(Hostile, ATextCutInTheMiddleOfALineIsRefused) {
    const Scan scan = test::boxesScan(24, 40, 5);
    const CartesianTables tables(scan);
    std::ostringstream text;
    text.precision(7);
    for (std::size_t k = 0; k < scan.cells(); ++k) {
        const Eigen::Vector3d p = tables.point(k);
        text << p.x() << " " << p.y() << " " << p.z() << "\n";
    }
    const std::string whole = text.str();
    ASSERT_TRUE(openScan(written("whole.xyz", whole)));
    const std::string cut = whole.substr(0, whole.find('\n', whole.size() * 7 / 10) - 2);
    const auto scanOfCut = openScan(written("cut.xyz", cut));
    ASSERT_FALSE(scanOfCut);
    EXPECT_NE(scanOfCut.error().sentence().find("cut off"), std::string::npos) << scanOfCut.error().sentence();
    const auto withoutLineEnd = openScan(written("bare.xyz", whole.substr(0, whole.size() - 1)));
    ASSERT_TRUE(withoutLineEnd);
    EXPECT_FALSE(withoutLineEnd->warnings.empty());
}

TEST_F(Hostile, RangesBetweenCountsAreNeverRoundedIntoARawGrid) {
    Scan scan = test::boxesScan(6, 8, 2);
    scan.rangeMm[3] = 2146.9995F;
    EXPECT_FALSE(saveScan(scan, folder / "between.json"));
    scan.rangeMm[3] = 2147.0F;
    scan.noReturnCodes = {70000, 0};
    scan.state[4] = CellState::NoReturn;
    ASSERT_TRUE(saveScan(scan, folder / "codes.json"));
    const auto back = openScan(folder / "codes.json");
    ASSERT_TRUE(back) << back.error().sentence();
    EXPECT_EQ(back->state[4], CellState::NoReturn);
}

TEST_F(Hostile, AMissingDataFileIsReported) {
    ASSERT_TRUE(saveScan(test::boxesScan(6, 8, 2), folder / "first.json"));
    std::filesystem::rename(folder / "first.json", folder / "second.json");
    std::filesystem::rename(folder / "first.u16", folder / "second.u16");
    const auto scan = openScan(folder / "second.json");
    ASSERT_TRUE(scan) << scan.error().sentence();
    ASSERT_FALSE(scan->warnings.empty());
    EXPECT_NE(scan->warnings.front().find("first.u16"), std::string::npos);
}

} // namespace
} // namespace edgescan::files
