// The placement of a scan: by --pose and --calibration, by the data of a recording, by the matrix of a PTX file.
#include "core/base/utc_time.h"
#include "core/files/open_save/open_scan.h"
#include "core/files/open_save/save_scan.h"
#include "core/files/recording/replay.h"
#include "core/files/recording/save_recording.h"
#include "core/files/recording/writer.h"
#include "core/scan/georef/place_scan.h"
#include "core/scan/georef/placed_points.h"
#include "core/scan/grid/acquisition.h"
#include "tests/support/bytes.h"
#include "tests/support/live_lines.h"
#include "tests/support/placements.h"
#include "tests/support/point_lists.h"
#include "tests/support/robot_files.h"
#include "tests/support/shared_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

using namespace edgescan;
using namespace edgescan::files;
using namespace edgescan::test;
using nlohmann::json;

namespace {

constexpr const char* kPoseText = R"({"format": "edgescan-pose/1", "robot": "example robot", "scan_start": "2026-11-20T10:00:00Z",
    "scan_end": "2026-11-20T10:00:40Z", "boom": {"azimuth_deg": 33.5},
    "inclinometer": {"time": "2026-11-20T10:00:01Z", "tilt_x_deg": 14.25, "tilt_y_deg": -3.4},
    "talin": {"time": "2026-11-20T10:00:01Z", "easting_m": 498765.432, "northing_m": 5150123.456, "elevation_m": 287.654,
              "heading_deg": 217.4, "heading_ref": "true", "pitch_deg": 5.75, "roll_deg": -2.1, "zone": "17N", "datum": "WGS84"}})";

scanner::SweepMetadata robotMetadata() {
    scanner::SweepMetadata keys = scanner::metadataOf(scanner::SweepSettings{});
    keys["R_IA"] = "[[0,0,1],[-1,0,0],[0,-1,0]]";
    keys["head_in_robot_m"] = "[4.2,1.3,2.65]";
    keys["talin_in_robot_m"] = "[-0.85,0.1,1.15]";
    keys["boresight_rpy_deg"] = "[0.05,-0.08,0.12]";
    keys["mount.rpy_deg"] = "[0.2,-0.1,0.15]";
    keys["mount.t_m"] = "[0.0015,0.004,0.035]";
    keys["boom_azimuth_deg"] = "33.5";
    keys["convergence_deg"] = "-0.35";
    return keys;
}

RecordingMessagePtr jsonMessage(RecordingTopic topic, std::int64_t ns, const json& object) {
    const std::string text = object.dump();
    return std::make_shared<const RecordingMessage>(RecordingMessage{topic, ns, Bytes(text.begin(), text.end())});
}

json talin(double east, int status = 0) {
    return {{"easting_m", east}, {"northing_m", 5150123.456}, {"elevation_m", 287.654}, {"heading_deg", 217.4}, {"pitch_deg", 5.75},
            {"roll_deg", -2.1},  {"heading_ref", "true"},     {"zone", "17N"},          {"datum", "WGS84"},     {"status", status}};
}

/// Thirty lines at 25 Hz; the given readings are seconds after the start, and easting.
Result<Scan> recorded(const scanner::SweepMetadata& metadata, const std::vector<std::pair<double, double>>& eastAt,
                      const ReadingOptions& options = {}, int status = 0) {
    std::vector<RecordingMessagePtr> messages;
    for (int line = 0; line < 30; ++line) messages.push_back(lineMessage(line));
    for (const auto& [seconds, east] : eastAt) {
        const std::int64_t ns = kEpochNs + static_cast<std::int64_t>(seconds * 1e9);
        messages.push_back(jsonMessage(RecordingTopic::Talin, ns, talin(east, status)));
        messages.push_back(jsonMessage(RecordingTopic::Inclinometer, ns, {{"tilt_x_deg", 14.25}, {"tilt_y_deg", -3.4}}));
    }
    const Bytes bytes = recordingBytes(metadata, messages);
    return readScanBytes(std::as_bytes(std::span(bytes)), ".mcap", options);
}

bool warns(const std::vector<std::string>& sentences, const std::string& part) {
    return std::any_of(sentences.begin(), sentences.end(), [&](const auto& s) { return s.find(part) != std::string::npos; });
}

} // namespace

TEST(RecordedPlace, TheDemoIsWhereTheReferenceSays) {
    EDGESCAN_NEEDS_SHARED("protocol/vectors");
    const auto path = edgescan::test::sharedFolder() / "protocol/vectors/sweep_demo.mcap";
    const auto scan = openScan(path);
    ASSERT_TRUE(scan) << scan.error().sentence();
    ASSERT_TRUE(scan->placement);
    // By shared/protocol/tools/frames.py, with the line angle at which the beam was measured.
    const std::tuple<int, int, double, double, double> kExpected[]{{0, 7, 498762.130024861544, 5150118.998931737617, 289.658622703694},
                                                                   {10, 400, 498762.930146205530, 5150118.058185938746, 289.818699892100},
                                                                   {23, 1000, 498765.647867999098, 5150117.905405015685, 289.831753657317}};
    for (const auto& [line, beam, e, n, h] : kExpected) {
        const MinePoint point = minePoint(*scan, scan->rangeMm.index(line, beam));
        EXPECT_LT((point.enhM - Eigen::Vector3d(e, n, h)).norm(), 4e-9) << line << ' ' << beam;
    }
    EXPECT_EQ(scan->placement->grid, "17N, WGS84");
    EXPECT_FALSE(scan->placement->outOfSpec);
    ASSERT_TRUE(scan->acquisition);
    EXPECT_EQ(scan->acquisition->serial, "18110550");
    EXPECT_EQ(scan->acquisition->model, "LMS511");
    EXPECT_EQ(scan->acquisition->startUtc, "2021-03-01T12:00:00.000Z");
}

TEST(RecordedPlace, ReadingsAndRobotOfARecordingPlaceItsSweep) {
    const auto scan = recorded(robotMetadata(), {{0.1, 498765.432}, {0.5, 498765.432}});
    ASSERT_TRUE(scan) << scan.error().sentence();
    ASSERT_TRUE(scan->placement);
    EXPECT_EQ(scan->placement->poses.size(), 1U);
    EXPECT_EQ(scan->placement->timeUtc, utcText(static_cast<double>(kEpochNs) * 1e-9 + 0.5));
    EXPECT_FALSE(scan->placement->outOfSpec);
    // The same numbers as files give the same placement.
    const Folder folder;
    writeText(folder / "robot.json", calibrationText(exampleCalibration()));
    writeText(folder / "pose.json", kPoseText);
    auto byFiles = openPlacement(folder / "pose.json", folder / "robot.json", *scan);
    ASSERT_TRUE(byFiles) << byFiles.error().sentence();
    EXPECT_LT(((*byFiles)->poses[0].rotation - scan->placement->poses[0].rotation).norm(), 1e-12);
    EXPECT_LT(((*byFiles)->poses[0].translationM - scan->placement->poses[0].translationM).norm(), 1e-8);
}

TEST(RecordedPlace, ABaseThatMovesGetsAPosePerLine) {
    const auto scan = recorded(robotMetadata(), {{-0.5, 498760.0}, {0.5, 498761.0}, {1.5, 498762.0}, {9.0, 498790.0}});
    ASSERT_TRUE(scan) << scan.error().sentence();
    ASSERT_TRUE(scan->placement);
    ASSERT_EQ(scan->placement->poses.size(), 30U);
    const Eigen::Vector3d step = scan->placement->poses[20].translationM - scan->placement->poses[10].translationM;
    EXPECT_NEAR(step.x(), 0.4, 1e-6) << "one metre per second, 10 lines of 40 ms";
    EXPECT_FALSE(scan->placement->outOfSpec);
    const auto late = recorded(robotMetadata(), {{0.5, 498760.0}, {0.9, 498761.0}});
    EXPECT_TRUE(late->placement->outOfSpec);
    EXPECT_TRUE(warns(late->placement->warnings, "lines were measured before the first or after the last pose"));
}

TEST(RecordedPlace, AnOldPoseIsOutOfSpecAndABadOneIsReported) {
    const auto old = recorded(robotMetadata(), {{-60.0, 498765.0}});
    ASSERT_TRUE(old->placement);
    EXPECT_TRUE(old->placement->outOfSpec);
    EXPECT_TRUE(warns(old->placement->warnings, "60 s older than the start"));
    const auto refused = recorded(robotMetadata(), {{0.2, 498765.0}}, {}, 3);
    ASSERT_TRUE(refused) << refused.error().sentence();
    EXPECT_FALSE(refused->placement);
    EXPECT_TRUE(warns(refused->warnings, "1 reading of inclinometer or TALIN cannot be used"));
    for (const auto& [key, bad] : {std::pair("R_IA", "[[1,0,0],[0,1,0],[0,0,2]]"), std::pair("talin_in_robot_m", "[1,2]"),
                                   std::pair("boresight_rpy_deg", "{"), std::pair("boom_azimuth_deg", "left")}) {
        scanner::SweepMetadata keys = robotMetadata();
        keys[key] = bad;
        const auto scan = recorded(keys, {{0.2, 498765.0}});
        ASSERT_TRUE(scan) << scan.error().sentence();
        EXPECT_FALSE(scan->placement) << key;
        EXPECT_TRUE(warns(scan->warnings, key)) << key;
    }
    scanner::SweepMetadata bare = robotMetadata();
    bare.erase("R_IA");
    EXPECT_TRUE(warns(recorded(bare, {{0.2, 498765.0}})->warnings, "--calibration ROBOT.json places the scan"));
    EXPECT_FALSE(warns(recorded(bare, {})->warnings, "--calibration")) << "without a pose no calibration can place the scan";
}

TEST(RecordedPlace, FilesTakeThePlaceOfWhatTheRecordingHolds) {
    const Folder folder;
    Calibration other = exampleCalibration();
    other.headInRobotM = {1, 1, 1};
    writeText(folder / "robot.json", calibrationText(other));
    writeText(folder / "pose.json", kPoseText);
    ReadingOptions options;
    options.calibration = (folder / "robot.json").string();
    scanner::SweepMetadata bare = robotMetadata();
    bare.erase("R_IA");
    bare.erase("head_in_robot_m");
    const auto placed = recorded(bare, {{0.2, 498765.0}}, options);
    ASSERT_TRUE(placed) << placed.error().sentence();
    ASSERT_TRUE(placed->placement);
    EXPECT_NE(placed->placement->source.find("the recording with robot.json (SHA-256 "), std::string::npos) << placed->placement->source;
    const auto noPose = recorded(bare, {}, options);
    ASSERT_FALSE(noPose);
    EXPECT_NE(noPose.error().sentence().find("give --pose POSE.json too"), std::string::npos) << noPose.error().sentence();
    options.calibration.clear();
    options.pose = (folder / "pose.json").string();
    EXPECT_TRUE(recorded(robotMetadata(), {}, options)->placement) << "the robot of the recording, the pose of the file";
    const auto noRobot = recorded(bare, {}, options);
    ASSERT_FALSE(noRobot);
    EXPECT_NE(noRobot.error().sentence().find("give --calibration ROBOT.json too"), std::string::npos);
}

TEST(PlaceByFlags, AnyFormatIsPlacedAndHalfAPlaceIsRefused) {
    const Folder folder;
    writeText(folder / "robot.json", calibrationText(exampleCalibration()));
    writeText(folder / "pose.json", kPoseText);
    const Scan made = makeScan({.axis = Axis::Spin, .lines = 12, .beams = 20, .lineStart = 0, .lineStep = 0.18});
    for (const char* name : {"scan.pcd", "scan.json", "scan.csv"}) {
        ASSERT_TRUE(saveScan(made, folder / name));
        ReadingOptions options;
        options.pose = (folder / "pose.json").string();
        const auto half = openScan(folder / name, options);
        ASSERT_FALSE(half) << name;
        EXPECT_NE(half.error().sentence().find("give --calibration"), std::string::npos) << half.error().sentence();
        options.calibration = (folder / "robot.json").string();
        const auto scan = openScan(folder / name, options);
        ASSERT_TRUE(scan) << scan.error().sentence();
        ASSERT_TRUE(scan->placement) << name;
        const auto expected = openPlacement(options.pose, options.calibration, *scan);
        EXPECT_EQ((*expected)->poses, scan->placement->poses);
        EXPECT_EQ(scan->openedWith, "") << "the place is in the record itself: the files need not be at hand to verify";
        options.pose.clear();
        EXPECT_FALSE(openScan(folder / name, options)) << name;
        options.pose = "/nowhere.json";
        EXPECT_FALSE(openScan(folder / name, options)) << name;
    }
}

TEST(PtxPlace, TheMatrixOfTheFileIsThePlace) {
    const Scan made = makeScan({});
    const Eigen::Matrix3d turn = rotationRpyDeg({10, -20, 130});
    const Eigen::Vector3d at(512000.25, 6200000.5, 300.125);
    const auto text = [&](const Eigen::Matrix3d& m) {
        std::string ptx = std::to_string(made.lines()) + "\n" + std::to_string(made.beams()) + "\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
        for (int i = 0; i < 3; ++i) ptx += numberText("%.6f ", m(0, i)) + numberText("%.6f ", m(1, i)) + numberText("%.6f 0\n", m(2, i));
        ptx += "512000.25 6200000.5 300.125 1\n";
        for (const auto& p : listOf(made, {}))
            ptx += numberText("%.6f ", p.x()) + numberText("%.6f ", p.y()) + numberText("%.6f 0.5\n", p.z());
        return ptx;
    };
    const auto scan = readBytes(text(turn), ".ptx");
    ASSERT_TRUE(scan) << scan.error().sentence();
    ASSERT_TRUE(scan->placement);
    EXPECT_EQ(scan->rangeMm, made.rangeMm);
    const CartesianTables tables(*scan);
    for (std::size_t k = 0; k < scan->cells(); k += 7) {
        if (scan->state[k] != CellState::Valid) continue;
        EXPECT_LT((minePoint(*scan, k).enhM - (turn * tables.point(k) + at)).norm(), 2e-5) << k; // the matrix has six decimals
    }
    EXPECT_TRUE(warns(scan->placement->warnings, "who registered it knows"));
    Eigen::Matrix3d stretched = turn;
    stretched.col(0) *= 1.1;
    const auto other = readBytes(text(stretched), ".ptx");
    ASSERT_TRUE(other) << other.error().sentence();
    EXPECT_FALSE(other->placement);
    EXPECT_TRUE(warns(other->warnings, "not a rotation and shift"));
    EXPECT_FALSE(readBytes(text(-turn), ".ptx")->placement) << "a mirror is no place";
}

TEST(RecordedPlace, PlaceAndScannerStayWithAScanThatIsSaved) {
    const Folder folder;
    const auto scan = recorded(robotMetadata(), {{0.1, 498765.432}});
    ASSERT_TRUE(scan && scan->placement && scan->acquisition);
    for (const char* name : {"s.json", "s.pcd", "s.ply", "s.csv", "s.las", "s.mcap"}) {
        ASSERT_TRUE(saveScan(*scan, folder / name, {.choices = {.comments = true}})) << name;
        const auto back = openScan(folder / name);
        ASSERT_TRUE(back) << back.error().sentence();
        ASSERT_TRUE(back->placement) << name;
        EXPECT_EQ(back->placement->poses, scan->placement->poses) << name;
        ASSERT_TRUE(back->acquisition) << name;
        EXPECT_EQ(back->acquisition->serial, scan->acquisition->serial) << name;
        EXPECT_EQ(back->acquisition->startUtc, scan->acquisition->startUtc) << name;
    }
}
