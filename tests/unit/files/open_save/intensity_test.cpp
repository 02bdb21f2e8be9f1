// Intensities: each stays with its point, in every format that holds them and with every method that finds the grid.
#include "core/files/open_save/open_scan.h"
#include "core/files/open_save/save_scan.h"
#include "core/files/point_tables/cloud_columns.h"
#include "tests/support/point_lists.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

using namespace edgescan;
using namespace edgescan::files;
using namespace edgescan::test;

namespace {

/// Integers that identify cells; NaN where there is no return.
Scan brightScan(float perStep = 1.0F) {
    Scan scan = makeScan(ScanShape{.lines = 24, .beams = 40});
    scan.intensity = Grid<float>(scan.lines(), scan.beams(), std::numeric_limits<float>::quiet_NaN());
    for (std::size_t k = 0; k < scan.cells(); ++k) {
        if (scan.state[k] == CellState::Valid) scan.intensity[k] = perStep * static_cast<float>(7 + k);
    }
    return scan;
}

void expectSameIntensity(const Scan& saved, const Scan& opened, const std::string& where) {
    ASSERT_EQ(opened.intensity.size(), saved.cells()) << where;
    for (std::size_t k = 0; k < saved.cells(); ++k) {
        if (saved.state[k] == CellState::Valid)
            ASSERT_EQ(opened.intensity[k], saved.intensity[k]) << where << " cell " << k;
        else
            ASSERT_TRUE(std::isnan(opened.intensity[k])) << where << " cell " << k;
    }
}

bool warned(const std::vector<std::string>& sentences, const char* part) {
    return std::ranges::any_of(sentences, [&](const std::string& s) { return s.find(part) != std::string::npos; });
}

} // namespace

TEST(Intensity, ComesBackFromEveryFormatThatHoldsIt) {
    const Folder folder;
    const Scan scan = brightScan();
    for (const char* name : {"a.pcd", "a.ply", "a.las", "a.csv"}) {
        const auto path = folder / name;
        ASSERT_TRUE(saveScan(scan, path)) << name;
        const auto opened = openScan(path);
        ASSERT_TRUE(opened) << opened.error().sentence();
        expectSameIntensity(scan, *opened, name);
        EXPECT_FALSE(warned(lostOnSaving(scan, path), "intensities")) << name;
    }
    for (const char* name : {"a.json", "a.xyz", "a.dxf"}) EXPECT_TRUE(warned(lostOnSaving(scan, folder / name), "intensities")) << name;
}

TEST(Intensity, PtxHoldsItFromNoneToOneAndOneHalfIsNone) {
    const Folder folder;
    const Scan scan = brightScan();
    ASSERT_TRUE(saveScan(scan, folder / "a.ptx"));
    const auto opened = openScan(folder / "a.ptx");
    ASSERT_TRUE(opened) << opened.error().sentence();
    ASSERT_EQ(opened->intensity.size(), scan.cells());
    float least = std::numeric_limits<float>::infinity(), greatest = -least;
    for (const float value : scan.intensity.cells) {
        if (std::isfinite(value)) least = std::min(least, value), greatest = std::max(greatest, value);
    }
    for (std::size_t k = 0; k < scan.cells(); ++k) {
        if (scan.state[k] == CellState::Valid) {
            ASSERT_NEAR(opened->intensity[k], (scan.intensity[k] - least) / (greatest - least), 1e-6) << k;
        }
    }
    Scan dark = scan;
    dark.intensity = {};
    ASSERT_TRUE(saveScan(dark, folder / "b.ptx"));
    EXPECT_EQ(openScan(folder / "b.ptx")->intensity.size(), 0U);
}

TEST(Intensity, LasStretchesWhatIsNoWholeNumberOf16Bits) {
    const Folder folder;
    const Scan scan = brightScan(0.001F);
    ASSERT_TRUE(saveScan(scan, folder / "a.las"));
    const auto opened = openScan(folder / "a.las");
    ASSERT_TRUE(opened) << opened.error().sentence();
    float before = -1;
    for (std::size_t k = 0; k < scan.cells(); ++k) {
        if (scan.state[k] != CellState::Valid) continue;
        EXPECT_GT(opened->intensity[k], before);
        before = opened->intensity[k];
    }
    EXPECT_EQ(before, 65535);
}

// Rows of another program in any order: the number of the point identifies its cell.
TEST(Intensity, FollowsItsPointThroughRecognitionAndProjection) {
    const Folder folder;
    const Scan scan = makeScan(ScanShape{.lines = 30, .beams = 50, .noReturns = 0.1});
    for (const bool shuffled : {false, true}) {
        const ListStyle style{.separator = ",", .shuffled = shuffled, .keepMissing = false};
        std::string text = "X,Y,Z,Reflectance\n";
        for (const Eigen::Vector3d& p : listOf(scan, style)) {
            for (int axis = 0; axis < 3; ++axis) text += numberText("%.6f", p[axis]) + ",";
            text += std::to_string(std::lround(p.norm() * 1000)) + "\n";
        }
        writeText(folder / "list.csv", text);
        for (const Projection projection : {Projection::Auto, Projection::Always}) {
            ReadingOptions options;
            options.projection = projection;
            const auto opened = openScan(folder / "list.csv", options);
            ASSERT_TRUE(opened) << opened.error().sentence();
            ASSERT_EQ(opened->intensity.size(), opened->cells());
            std::size_t told = 0;
            for (std::size_t k = 0; k < opened->cells(); ++k) {
                if (opened->state[k] != CellState::Valid) continue;
                ASSERT_NEAR(opened->intensity[k], opened->rangeMm[k], 1.0) << k;
                ++told;
            }
            EXPECT_GT(told, 800U);
        }
    }
}

TEST(Intensity, ARowWithoutItIsStillAPoint) {
    const Folder folder;
    const Scan scan = makeScan(ScanShape{.lines = 20, .beams = 30, .noReturns = 0});
    std::string text = "x y z intensity\n";
    bool first = true;
    for (const Eigen::Vector3d& p : listOf(scan, {})) {
        for (int axis = 0; axis < 3; ++axis) text += numberText("%.6f", p[axis]) + " ";
        text += first ? "nan\n" : "12\n";
        first = false;
    }
    writeText(folder / "list.xyz", text);
    const auto opened = openScan(folder / "list.xyz");
    ASSERT_TRUE(opened) << opened.error().sentence();
    EXPECT_EQ(countCells(*opened)[0], scan.cells());
    EXPECT_TRUE(std::isnan(opened->intensity[0]));
    EXPECT_EQ(opened->intensity[1], 12);
}

TEST(Intensity, ExportsCarryItAndPcdColoursAreTheFieldThatOthersKnow) {
    const Scan scan = brightScan();
    Grid<std::uint8_t> mask(scan.lines(), scan.beams());
    std::size_t edge = 0;
    while (scan.state[edge] != CellState::Valid) ++edge;
    mask[edge] = 255;
    const auto bytes = edgeBytes(scan, mask, "a.pcd", {});
    ASSERT_TRUE(bytes) << bytes.error().sentence();
    EXPECT_NE(bytes->find("FIELDS x y z line beam range_mm intensity rgb\n"), std::string::npos) << bytes->substr(0, 600);
    EXPECT_NE(bytes->find("TYPE F F F U U F F F\n"), std::string::npos);
    float intensity = 0;
    std::uint32_t colour = 0;
    std::memcpy(&intensity, bytes->data() + bytes->size() - 8, 4);
    std::memcpy(&colour, bytes->data() + bytes->size() - 4, 4);
    EXPECT_EQ(intensity, scan.intensity[edge]);
    EXPECT_EQ(colour, 0x0000FF00U); // green
}
