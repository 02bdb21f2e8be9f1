// Every number of the worked example, step by step; the error of tilting twice; and invariants.
#include "core/scan/georef/calibration.h"
#include "core/scan/georef/chain.h"
#include "core/scan/georef/place_scan.h"
#include "core/scan/georef/placed_points.h"
#include "core/scan/georef/rotations.h"
#include "tests/support/folders.h"
#include "tests/support/shared_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <Eigen/Dense>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>

using namespace edgescan;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using nlohmann::json;

namespace {

constexpr double kLocalM = 1e-9;
constexpr double kAbsoluteM = 4e-9;

Vector3d vectorOf(const json& j) { return {j[0].get<double>(), j[1].get<double>(), j[2].get<double>()}; }
Matrix3d matrixOf(const json& j) {
    Matrix3d m;
    for (int r = 0; r < 3; ++r) m.row(r) = vectorOf(j[static_cast<std::size_t>(r)]).transpose();
    return m;
}

/// The cases that tests/oracle/frames_cases.py computes independently of the program, then those of ../shared, if they exist.
json cases() {
    json all = json::parse(std::ifstream(test::sourceFolder() + "/tests/unit/scan/georef/frames_cases.json"))["cases"];
    if (std::ifstream file((edgescan::test::sharedFolder() / "protocol/vectors/frames_example.json").string()); file) {
        const json shared = json::parse(file);
        for (const json& one : shared["cases"]) all.push_back(one);
    }
    return all;
}

void expectPoint(const json& outputs, const char* name, const Vector3d& p, double tolerance = kLocalM) {
    EXPECT_LT((p - vectorOf(outputs[name])).cwiseAbs().maxCoeff(), tolerance) << name;
}

void expectMatrix(const json& outputs, const char* name, const Matrix3d& m) {
    EXPECT_LT((m - matrixOf(outputs["matrices"][name])).cwiseAbs().maxCoeff(), 1e-14) << name;
    EXPECT_LT(rotationError(m), 1e-14) << name;
}

// The first steps, which a scan does in its own geometry.
Vector3d sensorPoint(double beamDeg, double rangeM) {
    return {rangeM * std::cos(radians(beamDeg)), 0.0, rangeM * std::sin(radians(beamDeg))};
}
RigidTransform axisBaseFromMover(const Vector3d& axis, double stepperDeg) {
    return {rotationAbout(axis, radians(stepperDeg)), Vector3d::Zero()};
}

/// The steps one after the other, written out.
struct Steps {
    Matrix3d R_MS, R_AM, R_IA, R_LI, R_RL, R_VR, R_NV, R_NR;
    Vector3d p_S, p_M, p_A, p_I, p_L, p_R0, p_R, p_V, d_NED, d_ENU, local, world;
    PitchRoll head, robot;
    double phiDeg = 0, headingDeg = 0;
};

Steps stepsOf(const json& q) {
    Steps s;
    const auto number = [&](const char* key) { return q[key].get<double>(); };
    s.p_S = sensorPoint(number("beam_angle_deg"), number("range_m"));
    const RigidTransform mover = moverFromSensor(vectorOf(q["mount_rpy_deg"]), vectorOf(q["mount_t_m"]));
    s.p_M = mover * s.p_S;
    s.phiDeg = number("phi0_deg") + number("dir") * number("step_index") * number("deg_per_step");
    const RigidTransform base = axisBaseFromMover(vectorOf(q["axis"]), s.phiDeg);
    s.p_A = base * s.p_M;
    const RigidTransform inclinometer{matrixOf(q["R_IA"]), vectorOf(q["t_IA_m"])};
    s.p_I = inclinometer * s.p_A;
    s.head = *pitchRollOfElevations(number("tilt_x_deg"), number("tilt_y_deg"));
    const RigidTransform level = levelledFromInclinometer(s.head);
    s.p_L = level * s.p_I;
    const RigidTransform vehicle = vehicleFromRobot(vectorOf(q["boresight_rpy_deg"]), vectorOf(q["talin_in_robot_m"]));
    s.headingDeg = gridHeadingDeg(number("heading_true_deg"), number("convergence_deg"));
    s.R_NV = nedFromVehicle(s.headingDeg, number("pitch_deg"), number("roll_deg"));
    s.R_NR = s.R_NV * vehicle.rotation;
    s.robot = robotTilt(s.R_NR);
    s.R_RL = robotFromLevelled(s.robot, number("boom_azimuth_deg"));
    s.p_R0 = s.R_RL * s.p_L;
    s.p_R = RigidTransform{s.R_RL, vectorOf(q["head_in_robot_m"])} * s.p_L;
    s.p_V = vehicle * s.p_R;
    s.d_NED = s.R_NV * s.p_V;
    s.d_ENU = nedToEnu() * s.d_NED;
    const Vector3d origin = vectorOf(q["origin_ENH_m"]);
    s.local = localEnu(s.d_NED, vectorOf(q["talin_ENH_m"]), origin, q.value("grid_scale", 1.0));
    s.world = origin + s.local;
    s.R_MS = mover.rotation;
    s.R_AM = base.rotation;
    s.R_IA = inclinometer.rotation;
    s.R_LI = level.rotation;
    s.R_VR = vehicle.rotation;
    return s;
}

/// The same case as files and a scan.
Calibration calibrationOf(const json& q) {
    Calibration c;
    c.mountRpyDeg = vectorOf(q["mount_rpy_deg"]);
    c.mountM = vectorOf(q["mount_t_m"]);
    c.axis = vectorOf(q["axis"]);
    c.degPerStep = q["deg_per_step"].get<double>();
    c.zeroDeg = q["phi0_deg"].get<double>();
    c.direction = q["dir"].get<double>();
    const bool up = q["R_IA"][2][2].get<double>() == 1.0;
    c.viewing = up ? Viewing::Up : Viewing::Forward;
    c.inclinometerM = vectorOf(q["t_IA_m"]);
    c.headInRobotM = vectorOf(q["head_in_robot_m"]);
    c.talinInRobotM = vectorOf(q["talin_in_robot_m"]);
    c.boresightRpyDeg = vectorOf(q["boresight_rpy_deg"]);
    c.convergenceDeg = q["convergence_deg"].get<double>();
    c.gridScale = q.value("grid_scale", 1.0);
    return c;
}

PoseTrack posesOf(const json& q) {
    PoseTrack poses;
    poses.source = "example";
    poses.boomAzimuthDeg = q["boom_azimuth_deg"].get<double>();
    poses.inclinometer = {{kUnknownTime, q["tilt_x_deg"].get<double>(), q["tilt_y_deg"].get<double>()}};
    poses.talin = {{kUnknownTime, vectorOf(q["talin_ENH_m"]), q["heading_true_deg"].get<double>(), true, q["pitch_deg"].get<double>(),
                    q["roll_deg"].get<double>()}};
    return poses;
}

/// One line of one beam.
Scan scanOf(const json& q) {
    PolarGeometry polar;
    polar.axis = q["axis"][0].get<double>() == 1.0 ? Axis::Sweep : Axis::Spin;
    polar.beamDeg = {q["beam_angle_deg"].get<double>()};
    polar.lineDeg = {q["step_index"].get<double>() * q["deg_per_step"].get<double>()};
    Scan scan;
    scan.name = "example";
    scan.rangeMm = Grid<float>(1, 1, static_cast<float>(q["range_m"].get<double>() * 1000));
    scan.state = Grid<CellState>(1, 1, CellState::Valid);
    scan.geometry = polar;
    return scan;
}

} // namespace

TEST(Frames, EveryPointAndMatrixOfTheWorkedExample) {
    const json all = cases();
    EXPECT_GE(all.size(), 5U);
    for (const json& one : all) {
        SCOPED_TRACE(one["name"].get<std::string>());
        const json& out = one["outputs"];
        const Steps s = stepsOf(one["inputs"]);
        expectPoint(out, "p_S", s.p_S);
        expectPoint(out, "p_M", s.p_M);
        expectPoint(out, "p_A", s.p_A);
        expectPoint(out, "p_I", s.p_I);
        expectPoint(out, "p_L", s.p_L);
        expectPoint(out, "p_R0", s.p_R0);
        expectPoint(out, "p_R", s.p_R);
        expectPoint(out, "p_V", s.p_V);
        expectPoint(out, "d_NED", s.d_NED);
        expectPoint(out, "d_ENU", s.d_ENU);
        expectPoint(out, "local_ENU", s.local);
        expectPoint(out, "world_ENH", s.world, kAbsoluteM);
        expectMatrix(out, "R_MS", s.R_MS);
        expectMatrix(out, "R_AM", s.R_AM);
        expectMatrix(out, "R_IA", s.R_IA);
        expectMatrix(out, "R_LI", s.R_LI);
        expectMatrix(out, "R_RL", s.R_RL);
        expectMatrix(out, "R_VR", s.R_VR);
        expectMatrix(out, "R_NV", s.R_NV);
        expectMatrix(out, "R_NR", s.R_NR);
        const json& scalars = out["scalars"];
        EXPECT_NEAR(s.phiDeg, scalars["phi_deg"].get<double>(), 1e-12);
        EXPECT_NEAR(s.head.pitchDeg, scalars["head_pitch_deg"].get<double>(), 1e-12);
        EXPECT_NEAR(s.head.rollDeg, scalars["head_roll_deg"].get<double>(), 1e-12);
        EXPECT_NEAR(s.robot.pitchDeg, scalars["robot_pitch_deg"].get<double>(), 1e-12);
        EXPECT_NEAR(s.robot.rollDeg, scalars["robot_roll_deg"].get<double>(), 1e-12);
        EXPECT_NEAR(s.headingDeg, scalars["heading_grid_deg"].get<double>(), 1e-12);
    }
}

TEST(Frames, AScanPlacedByCalibrationAndPoseHitsTheExample) {
    for (const json& one : cases()) {
        SCOPED_TRACE(one["name"].get<std::string>());
        const json& q = one["inputs"];
        Scan scan = scanOf(q);
        const auto placement = placeScan(scan, calibrationOf(q), posesOf(q));
        ASSERT_TRUE(placement) << placement.error().sentence();
        // The example's own origin is rounded down to 50 m in height.
        const Vector3d shift = (*placement)->originEnhM - vectorOf(q["origin_ENH_m"]);
        EXPECT_EQ(shift, Vector3d(0, 0, 30));
        scan.placement = *placement;
        const MinePoint p = minePoint(scan, 0);
        expectPoint(one["outputs"], "local_ENU", p.localM + shift);
        expectPoint(one["outputs"], "world_ENH", p.enhM, kAbsoluteM);
        const PlacedPoints placed(scan);
        const Vector3d scannerPoint = placed.scanner(0, 0, p.localM);
        EXPECT_LT((placed.local(0, 0, scannerPoint) - p.localM).norm(), 1e-12);
        EXPECT_EQ(placed.mine(0, 0, scannerPoint), placed.originEnhM() + placed.local(0, 0, scannerPoint));
    }
}

TEST(Frames, TiltingTwiceIsAMetreOff) {
    const Steps s = stepsOf(cases()[0]["inputs"]);
    const Vector3d right = s.R_NR * s.p_R0;
    // The levelled point used as if the robot were level, too.
    const Vector3d wrong = s.R_NR * (rotationZ(radians(33.5)) * s.p_L);
    EXPECT_NEAR((wrong - right).norm(), 1.05, 0.005);
    // The right transform leaves the levelled point level: its height below the head is that of the levelled frame.
    EXPECT_NEAR(-right.z(), s.p_L.z(), 1e-12);
}

TEST(Frames, TheRobotsOwnTiltMovesOnlyTheLeverArms) {
    std::mt19937 random(5);
    const auto between = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
    for (int round = 0; round < 500; ++round) {
        const double azimuth = between(-180, 180);
        const double heading = between(0, 360);
        const RigidTransform level = levelledFromInclinometer({between(-60, 60), between(-60, 60)});
        const auto nedFromInclinometer = [&](double pitch, double roll) -> Matrix3d {
            const RigidTransform vehicle = vehicleFromRobot(Vector3d::Zero(), Vector3d(1, 2, 3));
            const Matrix3d nedFromRobot = nedFromVehicle(heading, pitch, roll) * vehicle.rotation;
            return nedFromRobot * robotFromLevelled(robotTilt(nedFromRobot), azimuth) * level.rotation;
        };
        const Matrix3d levelRobot = nedFromInclinometer(0, 0);
        const Matrix3d tilted = nedFromInclinometer(between(-40, 40), between(-40, 40));
        EXPECT_LT((levelRobot - tilted).cwiseAbs().maxCoeff(), 1e-13);
    }
}

TEST(Frames, SlewAboutTheRobotsAxisPointsTheBoomWhereTheInclinometerSays) {
    std::mt19937 random(6);
    const auto between = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
    for (int round = 0; round < 500; ++round) {
        const PitchRoll robot{between(-20, 20), between(-20, 20)};
        const double slew = between(-170, 170);
        const double eps = between(-40, 40);
        const Matrix3d rotation =
            levelling(radians(robot.pitchDeg), radians(robot.rollDeg)) * rotationZ(radians(slew)) * rotationY(radians(-eps));
        const Vector3d boom = rotation.col(0);
        const double elevation = degrees(std::asin(boom.z()));
        const auto azimuth = boomAzimuthOfSlew(robot, slew, elevation);
        ASSERT_TRUE(azimuth);
        EXPECT_NEAR(std::remainder(*azimuth - degrees(std::atan2(boom.y(), boom.x())), 360.0), 0.0, 1e-9);
        const auto level = boomAzimuthOfSlew({0, 0}, slew, elevation);
        ASSERT_TRUE(level);
        EXPECT_NEAR(*level, slew, 1e-9); // on a level robot both azimuths are the same
    }
    EXPECT_FALSE(boomAzimuthOfSlew({80, 0}, 0, 0.0) && boomAzimuthOfSlew({0, 89}, 0, 89.99));
    EXPECT_FALSE(pitchRollOfElevations(60, 45));
    EXPECT_FALSE(pitchRollOfElevations(90, 0));
}

TEST(Frames, TheOriginIsRoundedDown) {
    EXPECT_EQ(chooseOrigin({498765.432, 5150123.456, 287.654}), Vector3d(498700, 5150100, 280));
    EXPECT_EQ(chooseOrigin({-1.0, 0.0, -0.5}), Vector3d(-100, 0, -10));
}

TEST(Frames, AStepperThatMovesDuringALineKeepsEveryBeamsOwnMounting) {
    // With the ideal mounting the scan's own points already contain the skew, and no further rotation is allowed.
    PolarGeometry polar;
    polar.beamDeg = {10, 60, 120};
    polar.lineDeg = {5, 40};
    polar.lineSkewDeg = {0.01, 0.05, 0.09};
    Scan scan;
    scan.rangeMm = Grid<float>(2, 3, 10000.0F);
    scan.state = Grid<CellState>(2, 3, CellState::Valid);
    scan.geometry = polar;
    auto placement = std::make_shared<Placement>();
    placement->mount.sensorInMover = moverFromSensor({0.5, -0.3, 0.2}, {0.01, 0.02, 0.03});
    placement->mount.zeroDeg = 12;
    placement->mount.direction = -1;
    scan.placement = placement;
    for (std::size_t k = 0; k < scan.cells(); ++k) {
        const double phi = 12 - (polar.lineDeg[k / 3] + polar.lineSkewDeg[k % 3]);
        const Vector3d expected =
            axisBaseFromMover({0, 0, 1}, phi) * (placement->mount.sensorInMover * sensorPoint(polar.beamDeg[k % 3], 10.0));
        EXPECT_LT((minePoint(scan, k).localM - expected).norm(), 1e-12);
        const PlacedPoints placed(scan);
        const Vector3d there = placed.scanner(static_cast<int>(k / 3), static_cast<int>(k % 3), expected);
        EXPECT_LT((placed.local(static_cast<int>(k / 3), static_cast<int>(k % 3), there) - expected).norm(), 1e-12);
    }
}

TEST(Frames, NamesSayWhereNumbersAreNotMineCoordinates) {
    EXPECT_EQ(std::string(frameTail(CoordinateFrame::Scanner)), "_LOCAL");
    EXPECT_EQ(std::string(frameTail(CoordinateFrame::Mine)), "");
}
