// Calibration and pose files: values read back, refusals, and the text of refusals.
#include "core/base/utc_time.h"
#include "core/scan/georef/calibration.h"
#include "core/scan/georef/place_scan.h"
#include "tests/support/folders.h"
#include "tests/support/point_lists.h"
#include "tests/support/robot_files.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>

using namespace edgescan;
using namespace edgescan::test;
using nlohmann::json;

namespace {

template <class Refused>
void expectSentence(const Refused& result, const std::string& part) {
    ASSERT_FALSE(result) << part;
    EXPECT_NE(result.error().sentence().find(part), std::string::npos) << result.error().sentence();
}

json calibrationJson() { return json::parse(calibrationText(exampleCalibration())); }

json poseJson() {
    return json::parse(R"({"format": "edgescan-pose/1", "robot": "example robot", "scan_start": "2026-11-20T10:00:00Z",
        "scan_end": "2026-11-20T10:00:40.000Z", "boom": {"azimuth_deg": 33.5},
        "inclinometer": {"time": "2026-11-20T10:00:01Z", "tilt_x_deg": 14.25, "tilt_y_deg": -3.4},
        "talin": {"time": "2026-11-20T10:00:01Z", "easting_m": 498765.432, "northing_m": 5150123.456, "elevation_m": 287.654,
                  "heading_deg": 217.4, "heading_ref": "true", "pitch_deg": 5.75, "roll_deg": -2.1, "zone": "17N", "datum": "WGS84"}})");
}

Scan spinScan(int lines = 10) { return makeScan({.axis = Axis::Spin, .lines = lines, .beams = 8, .lineStart = 0, .lineStep = 0.18}); }

} // namespace

TEST(UtcTime, ReadsAndWrites) {
    EXPECT_EQ(parseUtc("1970-01-01T00:00:00Z"), 0.0);
    EXPECT_EQ(utcText(*parseUtc("2026-11-20T10:15:30.250Z")), "2026-11-20T10:15:30.250Z");
    EXPECT_EQ(utcText(*parseUtc("2024-02-29T23:59:59Z")), "2024-02-29T23:59:59.000Z");
    for (const char* bad : {"2026-02-30T00:00:00Z", "2026-11-20T10:15:30", "2026-11-20 10:15:30Z", "2026-11-20T24:15:30Z", "",
                            "2026-11-20T10:15:30.Z", "2026-11-20T10:15:30.2x0Z", "2026-1a-20T10:15:30Z"})
        EXPECT_FALSE(parseUtc(bad)) << bad;
    EXPECT_EQ(utcText(std::nan("")), "");
}

TEST(Calibration, TheExampleComesBackAsItWas) {
    const Folder folder;
    writeText(folder / "robot.json", calibrationText(exampleCalibration()));
    const auto back = openCalibration(folder / "robot.json");
    ASSERT_TRUE(back) << back.error().sentence();
    EXPECT_EQ(*back, exampleCalibration());
    EXPECT_EQ(back->mountRpyDeg, Eigen::Vector3d(0.2, -0.1, 0.15));
    Calibration c = exampleCalibration();
    c.viewing = Viewing::Matrix;
    c.viewingMatrix = inclinometerFromAxisBase(c).rotation;
    c.viewingMatrix << 0, 1, 0, -1, 0, 0, 0, 0, 1;
    c.armM = {3, 0, 0.1};
    c.slewAboutRobotZ = true;
    c.tilt = TiltReading::PitchRoll;
    c.direction = -1;
    c.zeroDeg = 90.000000000001;
    const auto all = parseCalibration(calibrationText(c), "robot.json");
    ASSERT_TRUE(all) << all.error().sentence();
    EXPECT_EQ(*all, c);
    EXPECT_EQ(all->zeroDeg, c.zeroDeg);
    const auto least = parseCalibration(R"({"format": "edgescan-calibration/1"})", "robot.json");
    ASSERT_TRUE(least) << least.error().sentence();
    EXPECT_EQ(*least, Calibration{});
}

TEST(Calibration, SaysWhatIsWrong) {
    const auto with = [](const char* section, const char* key, const json& value) {
        json object = calibrationJson();
        object[section][key] = value;
        return parseCalibration(object.dump(), "robot.json");
    };
    expectSentence(with("stepper", "mount_rpy", 3), "\"stepper.mount_rpy\" is not a key here, but \"mount_rpy_deg\" is");
    expectSentence(with("stepper", "mount_mm", 3), "but \"mount_m\" is");
    expectSentence(with("stepper", "colour", 3), "\"stepper.colour\" is not a key here; known are mount_rpy_deg");
    expectSentence(with("stepper", "axis", {0, 0, 0}), "\"stepper.axis\" has no direction");
    expectSentence(with("stepper", "axis", {0, 1}), "must hold three numbers");
    expectSentence(with("stepper", "mount_rpy_deg", "level"), "must hold three numbers");
    expectSentence(with("stepper", "mount_m", {1, 2, "x"}), "holds text where a number is needed");
    expectSentence(with("stepper", "direction", 0.5), "must be 1 or -1");
    expectSentence(with("stepper", "step_deg", 0), "is 0 and must be from 0.0001 to 10");
    expectSentence(with("inclinometer", "viewing", "sideways"), "must be \"forward\" or \"up\" or \"down\" or \"rpy\" or \"matrix\"");
    expectSentence(with("inclinometer", "rpy_deg", {0, 0, 0}), "needs \"viewing\": \"rpy\"");
    expectSentence(with("boom", "arm_m", {0, 0, 0}), "needs \"pivot_in_robot_m\"");
    expectSentence(with("talin", "in_robot_m", {400, 0, 0}), "is 400 and must be from -100 to 100");
    expectSentence(with("grid", "scale", 2), "must be from 0.99 to 1.01");
    json object = calibrationJson();
    object["inclinometer"]["viewing"] = "matrix";
    expectSentence(parseCalibration(object.dump(), "robot.json"), "\"inclinometer.matrix\" is missing");
    object["inclinometer"]["matrix"] = {{1, 0, 0}, {0, 1, 0}, {0, 0.1, 1}};
    expectSentence(parseCalibration(object.dump(), "robot.json"), "is not a rotation");
    object["inclinometer"]["matrix"] = {{1, 0, 0}, {0, 1, 0}, {0, 0, -1}};
    expectSentence(parseCalibration(object.dump(), "robot.json"), "mirrors instead of turning");
    expectSentence(parseCalibration("{\"format\": ", "robot.json"), "robot.json: byte");
    expectSentence(parseCalibration("{}", "robot.json"), "\"format\" is missing");
    expectSentence(parseCalibration("[]", "robot.json"), "no object");
    expectSentence(parseCalibration(R"({"format": "edgescan-pose/1"})", "robot.json"), "\"format\" is \"edgescan-pose/1\"");
    expectSentence(parseCalibration(std::string(40, '['), "robot.json"), "nested too deep");
    expectSentence(openCalibration("/nonexistent.json"), "/nonexistent.json: there is no such file");
}

TEST(Poses, AFileComesBackAsItWas) {
    const auto poses = parsePoses(poseJson().dump(), "dir/pose.json");
    ASSERT_TRUE(poses) << poses.error().sentence();
    EXPECT_EQ(poses->source, "pose.json");
    EXPECT_EQ(poses->talin[0].enhM, Eigen::Vector3d(498765.432, 5150123.456, 287.654));
    EXPECT_EQ(poses->grid, "17N, WGS84");
    const auto again = parsePoses(posesText(*poses), "dir/pose.json");
    ASSERT_TRUE(again) << again.error().sentence();
    EXPECT_EQ(posesText(*again), posesText(*poses));
    json mils = poseJson();
    mils["talin"].erase("heading_deg");
    mils["talin"]["heading_mil"] = 3200;
    const auto turned = parsePoses(mils.dump(), "pose.json");
    ASSERT_TRUE(turned) << turned.error().sentence();
    EXPECT_DOUBLE_EQ(turned->talin[0].headingDeg, 180.0);
}

TEST(Poses, SaysWhatIsWrong) {
    const auto with = [](const char* section, const char* key, const json& value) {
        json object = poseJson();
        object[section][key] = value;
        return parsePoses(object.dump(), "pose.json");
    };
    expectSentence(with("talin", "heading_mil", 3), "exclude each other");
    expectSentence(with("talin", "northing", 3), "but \"northing_m\" is");
    expectSentence(with("talin", "pitch_deg", 95), "\"talin.pitch_deg\" is 95 and must be from -90 to 90");
    expectSentence(with("talin", "roll_deg", 200), "a scanner that hangs has \"viewing\"");
    EXPECT_EQ(with("talin", "easting_m", "x").error().hint.find("viewing"), std::string::npos);
    expectSentence(with("talin", "time", "yesterday"), "must be a time in UTC like");
    expectSentence(with("talin", "heading_ref", "magnetic"), "must be \"true\" or \"grid\"");
    expectSentence(with("inclinometer", "tilt_x_deg", nullptr), "\"inclinometer.tilt_x_deg\" is missing");
    json object = poseJson();
    object.erase("talin");
    expectSentence(parsePoses(object.dump(), "pose.json"), "\"talin\" is missing");
    object = poseJson();
    object["scan_end"] = "2026-11-20T09:00:00Z";
    expectSentence(parsePoses(object.dump(), "pose.json"), "comes before \"scan_start\"");
    object = poseJson();
    object["inclinometer"] = {poseJson()["inclinometer"], poseJson()["inclinometer"]};
    expectSentence(parsePoses(object.dump(), "pose.json"), "must be in the order of time");
    object = poseJson();
    object["sweep"] = "moving";
    object["talin"].erase("time");
    expectSentence(parsePoses(object.dump(), "pose.json"), "needs a \"time\" in every reading");
}

TEST(Poses, TheExamplesOfTheDocumentationAreGood) {
    const std::string text = readText(std::filesystem::path(test::sourceFolder()) / "docs/reference/coordinates.md");
    std::vector<std::string> blocks;
    for (std::size_t at = 0; (at = text.find("```json\n", at)) != std::string::npos;) {
        const std::size_t end = text.find("```", at + 8);
        blocks.push_back(text.substr(at + 8, end - at - 8));
        at = end;
    }
    ASSERT_EQ(blocks.size(), 3U);
    const auto spins = parseCalibration(blocks[0], "docs"), sweeps = parseCalibration(blocks[1], "docs");
    ASSERT_TRUE(spins) << spins.error().sentence();
    ASSERT_TRUE(sweeps) << sweeps.error().sentence();
    EXPECT_EQ(*spins, exampleCalibration());
    const auto poses = parsePoses(blocks[2], "docs");
    ASSERT_TRUE(poses) << poses.error().sentence();
    for (const auto& [scan, robot] : {std::pair(spinScan(), *spins), std::pair(makeScan({.axis = Axis::Sweep}), *sweeps)}) {
        const auto placed = placeScan(scan, robot, *poses);
        ASSERT_TRUE(placed) << placed.error().sentence();
        const auto& warnings = (*placed)->warnings;
        if (robot.leftOut.empty()) {
            EXPECT_TRUE(warnings.empty());
        } else {
            ASSERT_EQ(warnings.size(), 1U);
            EXPECT_EQ(warnings[0], "The calibration does not give talin.boresight_rpy_deg, so 0 is used: add what is missing (Scan > Pose "
                                   "and Mounting, page Mounting).");
        }
    }
    EXPECT_TRUE(spins->leftOut.empty());
    EXPECT_FALSE(sweeps->leftOut.empty());
}

TEST(Poses, AHeadOfThePoseAndHeadingsOfTheGridNeedNoMounting) {
    Calibration robot;
    robot.leftOut = {kHeadKey, "talin.in_robot_m", kConvergenceKey};
    PoseTrack poses = *parsePoses(poseJson().dump(), "pose.json");
    const auto warningsOf = [&] { return (*placeScan(spinScan(), robot, poses))->warnings; };
    EXPECT_TRUE(std::ranges::count(warningsOf(),
                                   "The calibration does not give boom.head_in_robot_m, talin.in_robot_m, grid.convergence_deg, "
                                   "so 0 is used: add what is missing (Scan > Pose and Mounting, page Mounting)."));
    poses.headInRobotM = {1, 2, 3};
    for (TalinReading& reading : poses.talin) reading.trueNorth = false;
    EXPECT_TRUE(std::ranges::count(
        warningsOf(),
        "The calibration does not give talin.in_robot_m, so 0 is used: add what is missing (Scan > Pose and Mounting, page Mounting)."));
}

TEST(Poses, TwoFilesPlaceAScanAndAreNamedWithTheirHashes) {
    const Folder folder;
    writeText(folder / "robot.json", calibrationText(exampleCalibration()));
    writeText(folder / "pose.json", poseJson().dump());
    const auto placed = openPlacement(folder / "pose.json", folder / "robot.json", spinScan());
    ASSERT_TRUE(placed) << placed.error().sentence();
    EXPECT_TRUE((*placed)->source.starts_with("pose.json (SHA-256 ")) << (*placed)->source;
    EXPECT_NE((*placed)->source.find("robot.json (SHA-256 "), std::string::npos);
    EXPECT_EQ((*placed)->originEnhM, Eigen::Vector3d(498700, 5150100, 280));
    expectSentence(openPlacement(folder / "robot.json", folder / "pose.json", spinScan()), "choose a file with");
    expectSentence(openPlacement(folder / "none.json", folder / "robot.json", spinScan()), "none.json: there is no such file");
    const Scan sweep = makeScan({.axis = Axis::Sweep, .lines = 10, .beams = 8});
    expectSentence(openPlacement(folder / "pose.json", folder / "robot.json", sweep), (folder / "pose.json").string());
}

TEST(Poses, AgeAndTiltOutOfSpecAreSaid) {
    Calibration robot = exampleCalibration();
    const auto placed = [&](const json& object) {
        const auto poses = parsePoses(object.dump(), "pose.json");
        EXPECT_TRUE(poses) << poses.error().sentence();
        return *placeScan(spinScan(), robot, *poses);
    };
    const auto good = placed(poseJson());
    EXPECT_FALSE(good->outOfSpec);
    EXPECT_TRUE(good->warnings.empty());
    EXPECT_EQ(good->ageSeconds, -1.0);
    EXPECT_EQ(good->timeUtc, "2026-11-20T10:00:01.000Z");
    json old = poseJson();
    old["talin"]["time"] = "2026-11-20T09:59:25Z";
    const auto aged = placed(old);
    EXPECT_TRUE(aged->outOfSpec);
    EXPECT_EQ(aged->ageSeconds, 35.0);
    ASSERT_EQ(aged->warnings.size(), 1U);
    EXPECT_EQ(aged->warnings[0], "OUT OF SPEC: the pose is 35 s older than the start of the scan.");
    robot.poseAgeLimitS = 60;
    EXPECT_FALSE(placed(old)->outOfSpec);
    json shaken = poseJson();
    json later = shaken["inclinometer"];
    later["time"] = "2026-11-20T10:00:20Z";
    later["tilt_y_deg"] = -2.9;
    shaken["inclinometer"] = {shaken["inclinometer"], later};
    const auto moved = placed(shaken);
    EXPECT_TRUE(moved->outOfSpec);
    ASSERT_EQ(moved->warnings.size(), 1U);
    EXPECT_NE(moved->warnings[0].find("OUT OF SPEC: the tilt of the head changed by 0.5 degrees"), std::string::npos) << moved->warnings[0];
    json timeless = poseJson();
    timeless["inclinometer"].erase("time");
    const auto unknown = placed(timeless);
    EXPECT_TRUE(std::isnan(unknown->ageSeconds));
    EXPECT_EQ(unknown->warnings.size(), 1U);
}

TEST(Poses, WhatDoesNotBelongTogetherIsRefused) {
    const auto poses = parsePoses(poseJson().dump(), "pose.json");
    ASSERT_TRUE(poses);
    Calibration other = exampleCalibration();
    other.robot = "LHD 12";
    expectSentence(placeScan(spinScan(), other, *poses), "the pose is of robot \"example robot\" and the calibration of \"LHD 12\"");
    const Scan sweep = makeScan({.axis = Axis::Sweep, .lines = 10, .beams = 8});
    expectSentence(placeScan(sweep, exampleCalibration(), *poses), "the scan turns about x (sweep)");
    PoseTrack impossible = *poses;
    impossible.inclinometer[0].tiltYDeg = 80;
    expectSentence(placeScan(spinScan(), exampleCalibration(), impossible), "cannot be raised by");
    const std::vector<double> times(3, 0.0);
    expectSentence(placeScan(spinScan(), exampleCalibration(), *poses, times), "3 line times do not fit a scan of 10 lines");
    PoseTrack moving = *poses;
    moving.moving = true;
    moving.scanEndS = kUnknownTime;
    expectSentence(placeScan(spinScan(), exampleCalibration(), moving), "the times of the lines are not known");
}

TEST(Poses, AMovingBaseGetsAPosePerLine) {
    auto poses = *parsePoses(poseJson().dump(), "pose.json");
    poses.moving = true;
    const double start = poses.scanStartS;
    TalinReading first = poses.talin[0];
    TalinReading last = first;
    first.timeS = start;
    last.timeS = start + 40;
    first.headingDeg = 359;
    last.headingDeg = 3;
    last.enhM += Eigen::Vector3d(4, -2, 1);
    poses.talin = {first, last};
    poses.inclinometer = {{start, 10, 0}, {start + 40, 14, 0}};
    const TalinReading middle = talinAt(poses.talin, start + 20);
    EXPECT_NEAR(middle.headingDeg, 1.0, 0.02); // slerp of a tilted attitude is not quite linear in heading
    EXPECT_LT((middle.enhM - (first.enhM + Eigen::Vector3d(2, -1, 0.5))).norm(), 1e-8);
    EXPECT_DOUBLE_EQ(inclinometerAt(poses.inclinometer, start + 10).tiltXDeg, 11.0);
    EXPECT_EQ(talinAt(poses.talin, start - 5).headingDeg, 359);
    const auto placed = placeScan(spinScan(11), exampleCalibration(), poses);
    ASSERT_TRUE(placed) << placed.error().sentence();
    ASSERT_EQ((*placed)->poses.size(), 11U);
    EXPECT_FALSE((*placed)->outOfSpec);
    const Eigen::Vector3d way = (*placed)->poses.back().translationM - (*placed)->poses.front().translationM;
    EXPECT_NEAR(way.z(), 1.0, 0.3);
    poses.scanEndS = start + 50;
    const auto late = placeScan(spinScan(11), exampleCalibration(), poses);
    ASSERT_TRUE(late);
    EXPECT_TRUE((*late)->outOfSpec);
    EXPECT_NE((*late)->warnings[0].find("2 of 11 lines"), std::string::npos) << (*late)->warnings[0];
    poses.scanEndS = start + 40;
    poses.talin[1].enhM += Eigen::Vector3d(40'000, 0, 0);
    const auto fast = placeScan(spinScan(11), exampleCalibration(), poses);
    ASSERT_TRUE(fast);
    EXPECT_TRUE((*fast)->outOfSpec);
    EXPECT_NE((*fast)->warnings[0].find("faster than any machine"), std::string::npos) << (*fast)->warnings[0];
}

TEST(Poses, AStaticSweepIsAveragedAcrossNorth) {
    auto poses = *parsePoses(poseJson().dump(), "pose.json");
    TalinReading a = poses.talin[0];
    a.pitchDeg = a.rollDeg = 0;
    TalinReading b = a;
    a.headingDeg = 359.5;
    b.headingDeg = 0.9;
    b.enhM += Eigen::Vector3d(0.02, 0, 0);
    const std::vector<TalinReading> both{a, b};
    const TalinReading mean = averageTalin(both);
    EXPECT_NEAR(mean.headingDeg, 0.2, 1e-9);
    EXPECT_NEAR(mean.enhM.x(), a.enhM.x() + 0.01, 1e-9);
}
