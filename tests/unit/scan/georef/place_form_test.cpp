// Texts of the form become a pose file that the program reads, and come back from it; each wrong text has its sentence.
#include "core/base/angles.h"
#include "core/scan/georef/place_form.h"
#include "core/scan/georef/place_scan.h"
#include "core/scan/georef/placed_look.h"
#include "core/scan/georef/placed_points.h"
#include "tests/support/point_lists.h"
#include "tests/support/robot_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

using namespace edgescan;
using Eigen::Vector3d;

namespace {

using Values = std::map<std::string, std::string>;

PlaceTexts filled(std::span<const PlaceField> fields, const Values& values, PlaceTexts texts = {}) {
    texts.resize(fields.size());
    for (std::size_t n = 0; n < fields.size(); ++n) {
        if (const auto value = values.find(fields[n].key); value != values.end()) texts[n] = value->second;
    }
    return texts;
}

const Values kPose{{"easting_m", "498765.432"}, {"northing_m", "5150123,456"}, {"elevation_m", "287.654"}, {"heading_deg", "90"}};

TypedPlace typed(const Values& pose, const Values& mounting = {}, Axis axis = Axis::Spin) {
    return typedPlace({filled(poseFields(), pose)}, {filled(mountingFields(), mounting, nominalMounting(axis))});
}

/// The sentence about one field.
std::string faultAt(std::span<const PlaceField> fields, const PlaceTexts& faults, const std::string& key) {
    for (std::size_t n = 0; n < fields.size(); ++n) {
        if (key == fields[n].key) return faults[n];
    }
    return "no such field";
}

Scan placedBy(const TypedPlace& place, Axis axis) {
    Scan scan = test::makeScan({.axis = axis, .lines = 10, .beams = 8, .lineStart = 0, .lineStep = 0.18});
    const auto poses = parsePoses(place.file, "form");
    EXPECT_TRUE(poses) << (poses ? "" : poses.error().sentence());
    const auto placement = placeScan(scan, *poses->calibration, *poses);
    EXPECT_TRUE(placement) << (placement ? "" : placement.error().sentence());
    scan.placement = *placement;
    return scan;
}

/// The direction in the mine, east, north, up, of a direction in the scanner's frame.
Vector3d direction(const Scan& scan, const Vector3d& inScanner) {
    return localMinePoint(scan, 0, 0, inScanner) - localMinePoint(scan, 0, 0, Vector3d::Zero());
}

} // namespace

// What a scan without a pose shows above the scanner is above it with a level pose as well.
TEST(PlaceForm, ALevelPoseLeavesTheCloudUpright) {
    for (const Axis axis : {Axis::Spin, Axis::Sweep}) {
        const Scan scan = placedBy(typed(kPose, {}, axis), axis);
        EXPECT_LT((direction(scan, Vector3d::UnitZ()) - Vector3d::UnitZ()).norm(), 1e-9);
        EXPECT_LT((direction(scan, Vector3d::UnitY()) - Vector3d::UnitX()).norm(), 1e-9) << "heading 90 degrees is east";
    }
}

TEST(PlaceForm, AScannerThatHangsLooksDownWithoutASwapOfEastAndNorth) {
    for (const Axis axis : {Axis::Spin, Axis::Sweep}) {
        const Scan scan = placedBy(typed(kPose, {{"viewing", "down"}}, axis), axis);
        EXPECT_LT((direction(scan, Vector3d::UnitZ()) + Vector3d::UnitZ()).norm(), 1e-9);
        EXPECT_LT((direction(scan, Vector3d::UnitY()) - Vector3d::UnitX()).norm(), 1e-9) << "heading 90 degrees is east, as with up";
    }
}

TEST(PlaceForm, TheScannerIsAtTheTypedPlaceAndLooksAlongTheHeading) {
    for (const Axis axis : {Axis::Spin, Axis::Sweep}) {
        const TypedPlace place = typed(kPose, {{"viewing", "forward"}}, axis);
        ASSERT_TRUE(place.isSound()) << place.fault;
        const Scan scan = placedBy(place, axis);
        const Vector3d at = scan.placement->originEnhM + localMinePoint(scan, 0, 0, Vector3d::Zero());
        EXPECT_LT((at - Vector3d(498765.432, 5150123.456, 287.654)).norm(), 1e-8);
        EXPECT_LT((direction(scan, Vector3d::UnitZ()) - Vector3d::UnitX()).norm(), 1e-9) << "heading 90 degrees is east";
    }
    Values tilted = kPose;
    tilted["heading_deg"] = "0";
    tilted["tilt_x_deg"] = "30";
    const Vector3d ahead = direction(placedBy(typed(tilted, {{"viewing", "forward"}}), Axis::Spin), Vector3d::UnitZ());
    EXPECT_LT((ahead - Vector3d(0, std::cos(radians(30)), 0.5)).norm(), 1e-9) << "north, nose up";
}

TEST(PlaceForm, APoseThatDoesNotFitTheMountingIsDoubted) {
    const auto doubt = [](double pitchDeg, const char* viewing) {
        Values pose = kPose;
        pose["tilt_x_deg"] = std::to_string(pitchDeg);
        const TypedPlace place = typed(pose, {{"viewing", viewing}});
        return lookDoubt(placedLook(placedBy(place, Axis::Spin)), parsePoses(place.file, "form")->calibration->viewing);
    };
    EXPECT_EQ(doubt(0, "up"), LookDoubt::None);
    EXPECT_EQ(doubt(20, "up"), LookDoubt::None);
    EXPECT_EQ(doubt(90, "up"), LookDoubt::NotUp);
    EXPECT_EQ(doubt(0, "forward"), LookDoubt::TurnedForward);
    EXPECT_EQ(doubt(80, "forward"), LookDoubt::None);
    PlacedLook look;
    look.elevationDeg = 90;
    look.belowShare = 0.6;
    EXPECT_EQ(lookDoubt(look, Viewing::Up), LookDoubt::MostlyBelow);
    EXPECT_EQ(lookDoubt(look, Viewing::Rpy), LookDoubt::None) << "three angles were measured";
}

TEST(PlaceForm, EachWrongTextHasItsSentence) {
    const auto poseFault = [](const char* key, const char* text) {
        Values values = kPose;
        values[key] = text;
        const TypedPlace place = typed(values);
        EXPECT_FALSE(place.isSound()) << key;
        EXPECT_EQ(std::ranges::count_if(place.poseFaults, [](const std::string& fault) { return !fault.empty(); }), 1) << key;
        return faultAt(poseFields(), place.poseFaults, key);
    };
    EXPECT_EQ(poseFault("easting_m", ""), "Easting E is missing.");
    EXPECT_EQ(poseFault("easting_m", "here"), "Easting E: \"here\" is not a number.");
    EXPECT_EQ(poseFault("easting_m", "498765 5150123"), "Easting E: \"498765 5150123\" is not a number.");
    EXPECT_EQ(poseFault("elevation_m", "5150123"), "RL, positive up is 5150123 and must be from -20000 to 20000.");
    EXPECT_EQ(poseFault("heading_deg", "400"), "Heading, clockwise from north is 400 and must be from -360 to 360.");
    EXPECT_EQ(poseFault("tilt_x_deg", "91"), "Tilt: pitch, nose up is 91 and must be from -90 to 90.");
    const TypedPlace place = typed(kPose, {{"in_robot_m", "400, 0, 0"}, {"scale", "2"}, {"mount_m", "1 2"}});
    EXPECT_EQ(faultAt(mountingFields(), place.mountFaults, "in_robot_m"),
              "Lever arm of TALIN in the robot is 400 and must be from -100 to 100.");
    EXPECT_EQ(faultAt(mountingFields(), place.mountFaults, "scale"), "Scale of the grid is 2 and must be from 0.99 to 1.01.");
    EXPECT_EQ(faultAt(mountingFields(), place.mountFaults, "mount_m"), "Scanner on the stepper: \"1 2\" is not three numbers.");
    const TypedPlace together = typed(kPose, {{"viewing", "rpy"}});
    EXPECT_EQ(faultAt(mountingFields(), together.mountFaults, "rpy_deg"), "Looking direction is missing.");
}

TEST(PlaceForm, EveryNumberOfACalibrationComesBack) {
    for (const std::string& robot : {test::calibrationText(test::exampleCalibration()), test::calibrationText([] {
                                         Calibration c;
                                         c.viewing = Viewing::Matrix;
                                         c.viewingMatrix << 0, 1, 0, -1, 0, 0, 0, 0, 1;
                                         c.headInRobotM = {1, 2, 3};
                                         c.armM = {3, 0, 0.1};
                                         c.slewAboutRobotZ = true;
                                         c.tilt = TiltReading::PitchRoll;
                                         c.direction = -1;
                                         c.zeroDeg = 90.000000000001;
                                         c.poseAgeLimitS = 5;
                                         return c;
                                     }())}) {
        const auto texts = placeTexts(mountingFields(), robot, "robot.json");
        ASSERT_TRUE(texts) << texts.error().sentence();
        const auto file = typedMounting({*texts});
        ASSERT_TRUE(file) << file.error().what;
        const auto before = parseCalibration(robot, "before"), after = parseCalibration(*file, "after");
        ASSERT_TRUE(before && after);
        EXPECT_EQ(*after, *before);
    }
}

TEST(PlaceForm, AStoredPoseComesBackAndOtherKeysStay) {
    Values values = kPose;
    values["zone"] = "17N";
    values["tilt_y_deg"] = "-3.4";
    const TypedPlace place = typed(values, {{"convergence_deg", "-0.35"}, {"robot", "R1"}});
    ASSERT_TRUE(place.isSound());
    const auto pose = placeTexts(poseFields(), place.file, "pose.json");
    const auto mounting = placeTexts(mountingFields(), calibrationInPose(place.file), "pose.json");
    ASSERT_TRUE(pose && mounting);
    const TypedPlace again = typedPlace({*pose, place.file}, {*mounting, calibrationInPose(place.file)});
    EXPECT_EQ(again.file, place.file);
    // A file of a robot has times and readings of its own.
    const std::string robots = test::posesText(*parsePoses(place.file, "pose.json"));
    const auto base = nlohmann::ordered_json::parse(robots);
    const TypedPlace kept = typedPlace({*pose, R"({"format": "edgescan-pose/1", "scan_start": "2026-11-20T10:00:00Z"})"}, {*mounting});
    ASSERT_TRUE(kept.isSound()) << kept.fault;
    EXPECT_EQ(parsePoses(kept.file, "kept")->scanStartS, *parseUtc("2026-11-20T10:00:00Z"));
    EXPECT_FALSE(placeTexts(poseFields(), "[1", "damaged.json"));
}

TEST(PlaceForm, APoseFileMayHoldItsCalibration) {
    const TypedPlace place = typed(kPose, {{"in_robot_m", "-0.85, 0.1, 1.15"}});
    const auto poses = parsePoses(place.file, "pose.json");
    ASSERT_TRUE(poses);
    ASSERT_TRUE(poses->calibration);
    EXPECT_EQ(poses->calibration->talinInRobotM, Vector3d(-0.85, 0.1, 1.15));
    EXPECT_EQ(poses->calibration->tilt, TiltReading::PitchRoll);
    auto changed = nlohmann::json::parse(place.file);
    changed["calibration"]["grid"]["scale"] = 2;
    const auto wrong = parsePoses(changed.dump(), "pose.json");
    ASSERT_FALSE(wrong);
    EXPECT_NE(wrong.error().sentence().find("\"grid.scale\" is 2"), std::string::npos);
}
