// Poses, frames, attached points and records from outside.
#include "core/files/open_save/save_scan.h"
#include "core/files/recording/writer.h"
#include "core/scan/georef/calibration.h"
#include "tests/support/folders.h"
#include "tests/support/live_lines.h"
#include "tests/support/placements.h"
#include "tests/support/robot_files.h"
#include "tests/support/run_program.h"
#include "tests/support/scans.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <array>
#include <fstream>
#include <map>

namespace edgescan {
namespace {

using nlohmann::json;
using test::runCli;

std::string lastLine(const std::string& text) {
    const std::size_t end = text.find_last_not_of('\n') + 1;
    const std::size_t before = text.rfind('\n', end == 0 ? 0 : end - 1);
    return text.substr(before == std::string::npos ? 0 : before + 1, end);
}

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

// One rule for every format: the mine grid where the scan has a place, and the same scan again.
TEST_F(CliPlace, EveryFormatIsInTheMineGridIfThereIsAPoseAndOpensAsTheSameScan) {
    struct Case {
        const char* name;
        const char* flags;
        bool opens = true;
    };
    constexpr std::array<Case, 14> kCases{{{"w.pcd", ""},
                                           {"t.pcd", "--ascii"},
                                           {"d.pcd", "--doubles"},
                                           {"w.ply", ""},
                                           {"t.ply", "--ascii"},
                                           {"w.las", ""},
                                           {"w.csv", ""},
                                           {"c.csv", "--comments"},
                                           {"w.xyz", ""},
                                           {"w.obj", ""},
                                           {"w.ptx", ""},
                                           {"w.json", ""},
                                           {"w.mcap", ""},
                                           {"w.dxf", "", false}}};
    for (const bool posed : {false, true}) {
        const std::string in = posed ? placed() : path("boxes.json");
        const json before = json::parse(runCli("detect " + in + " --json -").out);
        for (const Case& one : kCases) {
            SCOPED_TRACE(std::string(one.name) + " " + one.flags + (posed ? " with a pose" : " without a pose"));
            const auto run = runCli("convert " + in + " " + path(one.name) + " " + one.flags);
            ASSERT_EQ(run.code, 0) << run.err;
            const std::string name = one.name;
            const bool measurements = name == "w.json" || name == "w.mcap";
            const json record = json::parse(test::fileText(folder / (name + ".provenance.json")))["record"];
            EXPECT_EQ(record["coordinates"]["frame"], posed && !measurements ? "mine grid" : "scanner");
            const std::string last = lastLine(run.err);
            EXPECT_NE(last.find(name + ": " +
                                (measurements ? "Ranges and angles of the scanner, "
                                 : posed      ? "Mine grid: E 6207"
                                              : "Scanner frame, as the scan has no pose: x ")),
                      std::string::npos)
                << last;
            if (!one.opens) continue;
            const json after = json::parse(runCli("detect " + path(one.name) + " --json -").out);
            for (const char* key : {"edge_mask_sha256", "lines", "beams", "frame", "pose"}) EXPECT_EQ(after[key], before[key]) << key;
            if (name != "w.csv" && name != "w.xyz" && name != "w.obj" && name != "w.ptx") {
                EXPECT_EQ(after["cells"], before["cells"]);
            }
        }
    }
}

TEST_F(CliPlace, TheLastLineOfEveryExportNamesWhatNeedsTheLocalFrame) {
    const auto ply = runCli("convert " + placed() + " " + path("w.ply"));
    EXPECT_NE(lastLine(ply.err).find("use the local frame (--frame local): 4-byte numbers step by 500 mm here."), std::string::npos)
        << ply.err;
    EXPECT_NE(lastLine(ply.err).find("For MeshLab, "), std::string::npos) << ply.err;
    const auto pcd = runCli("convert " + placed() + " " + path("w.pcd"));
    EXPECT_NE(lastLine(pcd.err).find(".pcd: 4-byte metres from E 620700, N 6200100, RL 280."), std::string::npos) << pcd.err;
    const auto local = runCli("convert " + placed() + " " + path("w.obj") + " --frame local");
    EXPECT_NE(lastLine(local.err).find("Local metres from E 620700, N 6200100, RL 280 in the mine grid: east "), std::string::npos)
        << local.err;
    EXPECT_EQ(local.err.find("MeshLab"), std::string::npos) << local.err;
    const auto detect = runCli("detect " + placed() + " -o " + path("all"));
    EXPECT_NE(lastLine(detect.err).find(path("all") + ": Mine grid: E 6207"), std::string::npos) << detect.err;
    const auto rocks = runCli("rocks " + placed() + " --frame scanner --csv " + path("r.csv"));
    EXPECT_NE(lastLine(rocks.err).find("r.csv: Scanner frame: x "), std::string::npos) << rocks.err;
    const std::string mask = runCli("detect " + path("boxes.json") + " --mask " + path("m.png")).err;
    EXPECT_NE(lastLine(mask).find("written to " + path("m.png")), std::string::npos) << "a picture has no coordinates: " << mask;
}

TEST_F(CliPlace, BatchStatesTheFrameOfEveryFile) {
    const auto run = runCli("batch " + placed() + " --no-survey --results edges.csv,mask -o " + path("results"));
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(json::parse(run.out)["frames"], json({{"mine grid", 1}}));
    const json row = json::parse(test::fileText(folder / "results/results.ndjson"));
    for (const json& output : row["outputs"]) {
        const bool holds = output["file"] == "edges.csv";
        EXPECT_EQ(output.contains("frame"), holds) << output;
        EXPECT_EQ(holds, output.value("coordinates", "").starts_with("Mine grid: E 6207")) << output;
    }
}

// The examples of the page are files that work: one calibration for each mounting.
TEST_F(CliPlace, TheExamplesOfThePageAreUsable) {
    std::map<std::string, std::string> examples; // "edgescan-pose/1", and a calibration by its axis
    const std::string page = test::fileText(std::filesystem::path(test::sourceFolder()) / "docs/reference/coordinates.md");
    const std::string fence = "```json\n";
    for (std::size_t at = page.find(fence); at != std::string::npos; at = page.find(fence, at + 1)) {
        const std::string text = page.substr(at + fence.size(), page.find("```", at + fence.size()) - at - fence.size());
        const json example = json::parse(text);
        examples[example.contains("stepper") ? example["stepper"]["axis"].dump() : example["format"].get<std::string>()] = text;
    }
    ASSERT_EQ(examples.size(), 3U) << page;
    write(folder / "pose.json", examples.at("edgescan-pose/1"));
    const std::map<std::string, Axis> mountings{{"[0,0,1]", Axis::Spin}, {"[1,0,0]", Axis::Sweep}};
    for (const auto& [axis, mounting] : mountings) {
        SCOPED_TRACE(axis);
        write(folder / "robot.json", examples.at(axis));
        Scan scan = test::boxesScan(20, 30, 3, 0.05);
        std::get<PolarGeometry>(scan.geometry).axis = mounting;
        ASSERT_TRUE(files::saveScan(scan, folder / "boxes.json"));
        const auto info = runCli("info " + placed());
        ASSERT_EQ(info.code, 0) << info.err;
        EXPECT_EQ(json::parse(info.out)["frame"], "mine grid");
        const auto csv = runCli("convert " + placed() + " " + path("w.csv"));
        EXPECT_EQ(csv.code, 0) << csv.err;
    }
}

TEST_F(CliPlace, LinksLeadToWhatIsBesideTheirFiles) {
    ASSERT_EQ(runCli("convert " + placed() + " " + path("w.csv")).code, 0);
    std::filesystem::create_directory(folder / "links");
    for (const char* name : {"boxes.json", "boxes.u16", "w.csv"}) {
        const std::filesystem::path link = folder / "links" / (std::string("link") + std::filesystem::path(name).extension().string());
        std::filesystem::create_symlink(folder / name, link);
        const auto info = runCli("info " + link.string());
        EXPECT_EQ(info.code, 0) << info.err;
        const json opened = json::parse(info.out);
        EXPECT_EQ(opened["lines"], 40) << name;
        EXPECT_EQ(opened["frame"], std::string(name) == "w.csv" ? "mine grid" : "scanner");
        EXPECT_EQ(runCli("verify " + link.string()).code, std::string(name) == "w.csv" ? 0 : 1) << "only exports have records";
        std::filesystem::remove(link);
    }
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
