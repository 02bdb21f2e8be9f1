// Poses, frames, attached points and records from outside.
#include "core/files/open_save/save_scan.h"
#include "core/files/recording/writer.h"
#include "core/scan/georef/calibration.h"
#include "tests/support/live_lines.h"
#include "tests/support/placements.h"
#include "tests/support/robot_files.h"
#include "tests/support/run_program.h"
#include "tests/support/scans.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>

namespace edgescan {
namespace {

using nlohmann::json;
using test::runCli;

void write(const std::filesystem::path& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

class CliPlace : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_TRUE(files::saveScan(test::boxesScan(40, 60, 3, 0.05), folder / "boxes.json"));
        write(folder / "robot.json", test::calibrationText(robot()));
        write(folder / "pose.json", R"({"format": "edgescan-pose/1", "robot": "example robot", "boom": {"azimuth_deg": 33.5},
            "inclinometer": {"tilt_x_deg": 14.25, "tilt_y_deg": -3.4},
            "talin": {"easting_m": 620765.432, "northing_m": 6200123.456, "elevation_m": 287.654, "heading_deg": 217.4,
                      "pitch_deg": 5.75, "roll_deg": -2.1}})");
    }
    static Calibration robot() {
        Calibration c = test::exampleCalibration();
        c.axis = {1, 0, 0}; // the scan of boxes is a sweep
        return c;
    }
    [[nodiscard]] std::string path(const char* name) const { return (folder / name).string(); }
    [[nodiscard]] std::string placed() const {
        return path("boxes.json") + " --pose " + path("pose.json") + " --calibration " + path("robot.json");
    }
    test::TemporaryFolder folder;
};

TEST_F(CliPlace, MineCoordinatesNeedAPoseAndSayWhy) {
    const auto refused = runCli("detect " + path("boxes.json") + " --frame mine --edges " + path("e.csv"));
    EXPECT_EQ(refused.code, 1);
    EXPECT_NE(refused.err.find("the scan has no pose, so its place in the mine grid is not known"), std::string::npos) << refused.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "e.csv"));
    EXPECT_EQ(runCli("convert " + path("boxes.json") + " " + path("e.ply") + " --frame mine").code, 1);
    EXPECT_EQ(runCli("detect " + path("boxes.json") + " --frame elsewhere").code, 2);
    const auto half = runCli("info " + path("boxes.json") + " --pose " + path("pose.json"));
    EXPECT_EQ(half.code, 1);
    EXPECT_NE(half.err.find("--calibration ROBOT.json"), std::string::npos) << half.err;
}

TEST_F(CliPlace, APlacedScanIsExportedInTheMineAndNamesTellTheFrame) {
    const auto info = json::parse(runCli("info " + placed()).out);
    EXPECT_EQ(info["frame"], "mine grid");
    EXPECT_EQ(info["pose"]["origin_enh_m"], json({620700.0, 6200100.0, 280.0}));
    EXPECT_NE(info["pose"]["source"].get<std::string>().find("pose.json (SHA-256 "), std::string::npos);
    ASSERT_EQ(runCli("detect " + placed() + " -o " + path("mine") + " --operator 'R. Operator' --role blaster").code, 0);
    ASSERT_EQ(runCli("detect " + placed() + " -o " + path("scanner") + " --frame scanner").code, 0);
    ASSERT_EQ(runCli("detect " + placed() + " -o " + path("local") + " --frame local --ascii").code, 0);
    for (const char* name :
         {"mine/boxes_edges.pcd", "mine/boxes_cloud.pcd", "scanner/boxes_edges_LOCAL.pcd", "local/boxes_cloud_OFFSET.pcd"})
        EXPECT_TRUE(std::filesystem::exists(folder / name)) << name;
    EXPECT_NE(test::fileText(folder / "local/boxes_cloud_OFFSET.pcd").find("DATA ascii"), std::string::npos);
    const json record = json::parse(test::fileText(folder / "mine/boxes_edges.pcd.provenance.json"))["record"];
    EXPECT_EQ(record["operator"], "R. Operator");
    EXPECT_EQ(record["role"], "blaster");
    EXPECT_EQ(record["coordinates"]["frame"], "mine grid");
    // The record contains the pose's numbers: its file may be deleted.
    std::filesystem::remove(folder / "pose.json");
    std::filesystem::remove(folder / "robot.json");
    const auto verified = runCli("verify " + path("mine/boxes_edges.pcd") + " " + path("local/boxes_cloud_OFFSET.pcd") + " --scans " +
                                 folder.path().string());
    EXPECT_EQ(verified.code, 0) << verified.out << verified.err;
}

TEST_F(CliPlace, ConvertLeavesARecordThatVerifies) {
    for (const char* name : {"w.pcd", "w.csv", "w.las", "w.ptx", "w.json", "w.mcap", "w.dxf"}) {
        const auto run = runCli("convert " + placed() + " " + path(name));
        ASSERT_EQ(run.code, 0) << run.err;
        const auto verified = runCli("verify " + path(name));
        EXPECT_EQ(verified.code, 0) << verified.out << verified.err;
    }
    EXPECT_NE(runCli("convert " + placed() + " " + path("w.obj")).err.find("The file holds points and no grid"), std::string::npos);
    EXPECT_EQ(json::parse(runCli("info " + path("w.pcd")).out)["pose"], json::parse(runCli("info " + placed()).out)["pose"]);
}

TEST_F(CliPlace, ReplayPlacesTheSweepAsDetectDoes) {
    scanner::SweepMetadata keys = scanner::metadataOf(scanner::SweepSettings{});
    const std::string pose =
        R"({"easting_m":498765.4,"northing_m":5150123.4,"elevation_m":287.6,"heading_deg":217.4,"pitch_deg":5.7,"roll_deg":-2})";
    const std::string tilt = R"({"tilt_x_deg":14.25,"tilt_y_deg":-3.4})";
    keys["boom_azimuth_deg"] = "33.5";
    std::vector<files::RecordingMessagePtr> messages;
    for (int line = 0; line < 40; ++line) messages.push_back(test::lineMessage(line));
    messages.push_back(std::make_shared<const files::RecordingMessage>(
        files::RecordingMessage{files::RecordingTopic::Talin, test::kEpochNs + 500'000'000, Bytes(pose.begin(), pose.end())}));
    messages.push_back(std::make_shared<const files::RecordingMessage>(
        files::RecordingMessage{files::RecordingTopic::Inclinometer, test::kEpochNs + 500'000'000, Bytes(tilt.begin(), tilt.end())}));
    ASSERT_TRUE(files::saveMessages(folder / "s.mcap", keys, messages));
    write(folder / "spin.json", test::calibrationText(test::exampleCalibration()));
    const std::string flags = path("s.mcap") + " --calibration " + path("spin.json");
    const json detected = json::parse(runCli("detect " + flags + " --json -").out);
    const auto replay = runCli("replay --quiet " + flags);
    ASSERT_EQ(replay.code, 0) << replay.err;
    const json result = json::parse(replay.out)["result"];
    EXPECT_EQ(detected["frame"], "mine grid");
    EXPECT_EQ(result["pose"], detected["pose"]);
    EXPECT_EQ(result["edge_mask_sha256"], detected["edge_mask_sha256"]);
}

TEST(CliAttached, ConvertSaysWhatStaysBehindAndTakesItAlongWhenAsked) {
    const test::TemporaryFolder folder;
    std::mt19937 random(4);
    std::uniform_real_distribution<double> unit(-1, 1);
    std::string cloud = "ply\nformat ascii 1.0\nelement vertex 5000\nproperty double x\nproperty double y\nproperty double z\nend_header\n";
    for (int n = 0; n < 5000; ++n) {
        const double x = n % 2 == 0 ? 3 : 5;
        cloud += std::to_string(x) + " " + std::to_string(x * unit(random)) + " " + std::to_string(x * unit(random)) + "\n";
    }
    write(folder / "cloud.ply", cloud);
    const std::string flags = " --sensor 0,0,0 --project always --grid-step 3 ";
    const std::string in = (folder / "cloud.ply").string();
    const json info = json::parse(runCli("info " + in + flags).out);
    ASSERT_GT(info["attached_points"].get<int>(), 100);
    const auto grid = runCli("convert " + in + flags + (folder / "grid.pcd").string());
    ASSERT_EQ(grid.code, 0);
    EXPECT_NE(grid.err.find(info["attached_points"].dump() + " points behind the nearest of their cell are not in this file"),
              std::string::npos)
        << grid.err;
    const auto all = runCli("convert --include-attached " + in + flags + (folder / "all.pcd").string());
    ASSERT_EQ(all.code, 0) << all.err;
    EXPECT_EQ(json::parse(test::fileText(folder / "all.pcd.provenance.json"))["export"]["points"], 5000);
    ASSERT_EQ(runCli("detect --include-attached " + in + flags + " --edges " + (folder / "e.las").string()).code, 0);
    EXPECT_EQ(
        runCli("verify " + (folder / "e.las").string() + " " + (folder / "all.pcd").string() + " " + (folder / "grid.pcd").string()).code,
        0);
}

} // namespace
} // namespace edgescan
