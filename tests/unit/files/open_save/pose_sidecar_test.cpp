// The pose sidecar of a scan places it for every program; a pose that was asked for comes first; the file may be replaced while the scan is
// open.
#include "core/base/inputs.h"
#include "core/base/whole_file.h"
#include "core/files/open_save/open_scan.h"
#include "core/files/open_save/pose_sidecar.h"
#include "core/files/open_save/save_scan.h"
#include "core/scan/georef/place_form.h"
#include "core/scan/grid/placement.h"
#include "tests/support/point_lists.h"
#include "tests/support/robot_files.h"
#include "tests/support/run_program.h"

#include <gtest/gtest.h>

using namespace edgescan;
using namespace edgescan::files;

namespace {

std::string poseAt(const char* easting) {
    PlaceTexts pose(poseFields().size());
    pose[0] = easting;
    pose[1] = "5150123.456";
    pose[2] = "287.654";
    pose[3] = "217.4";
    return typedPlace({pose}, {nominalMounting(Axis::Spin)}).file;
}

} // namespace

struct PoseSidecar : ::testing::Test {
    test::TemporaryFolder folder;
    std::string scan = (folder / "wall.json").string();
    void SetUp() override {
        ASSERT_TRUE(saveScan(test::makeScan({.axis = Axis::Spin, .lines = 10, .beams = 8, .lineStart = 0, .lineStep = 0.18}), scan));
    }
};

TEST_F(PoseSidecar, PlacesTheScanWhoeverOpensIt) {
    EXPECT_EQ(openScan(scan)->placement, nullptr);
    ASSERT_TRUE(writePoseSidecar(scan, poseAt("498765.432")));
    EXPECT_EQ(poseSidecar(scan), scan + ".pose.json");
    const auto placed = openScan(scan);
    ASSERT_TRUE(placed) << placed.error().sentence();
    ASSERT_NE(placed->placement, nullptr);
    EXPECT_EQ(placed->placement->originEnhM, Eigen::Vector3d(498700, 5150100, 280));
    EXPECT_TRUE(placed->placement->source.starts_with("wall.json.pose.json (SHA-256 ")) << placed->placement->source;
    // One that was asked for comes first.
    const std::string other = (folder / "other.json").string();
    ASSERT_TRUE(writeWholeFile(other, poseAt("100000")));
    ReadingOptions asked;
    asked.pose = other;
    EXPECT_EQ(openScan(scan, asked)->placement->originEnhM.x(), 100000);
    ASSERT_TRUE(writePoseSidecar(scan, std::nullopt));
    EXPECT_EQ(openScan(scan)->placement, nullptr);
    EXPECT_FALSE(*readPoseSidecar(scan));
}

TEST_F(PoseSidecar, ADamagedOneIsRefusedByName) {
    ASSERT_TRUE(writePoseSidecar(scan, "{\"format\": "));
    const auto opened = openScan(scan);
    ASSERT_FALSE(opened);
    EXPECT_NE(opened.error().sentence().find("wall.json.pose.json"), std::string::npos) << opened.error().sentence();
}

TEST_F(PoseSidecar, MayBeReplacedWhileTheScanIsOpenAndByNoExport) {
    ASSERT_TRUE(writePoseSidecar(scan, poseAt("498765.432")));
    const BindInputs inputs;
    const auto opened = openScan(scan);
    ASSERT_TRUE(opened);
    const auto claims = inputs.claims();
    EXPECT_FALSE(writeWholeFile(poseSidecar(scan), std::string("an export")));
    ASSERT_TRUE(writePoseSidecar(scan, poseAt("498865.432")));
    EXPECT_EQ(openScan(scan)->placement->originEnhM.x(), 498800);
    EXPECT_EQ(*readPoseSidecar(scan), poseAt("498865.432"));
    EXPECT_FALSE(std::filesystem::exists(scan + ".pose.json.new"));
}
