// Reads the robot's calibration file.
#include "core/scan/georef/calibration.h"

#include "core/base/inputs.h"
#include "core/base/json_fields.h"
#include "core/base/whole_file.h"
#include "core/scan/georef/chain.h"
#include "core/scan/georef/rotations.h"

#include <cmath>

namespace edgescan {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr const char* kCalibrationFormat = "edgescan-calibration/1";
const std::vector<std::string> kViewings{"forward", "up", "down", "rpy", "matrix"};
const std::vector<std::string> kTilts{"elevations", "pitch_roll"};
const std::vector<std::string> kAzimuths{"vertical", "robot_z"};
constexpr NumberLimits kLever = physical::kLeverM.limits;
constexpr NumberLimits kAngle = physical::kBeamDeg.limits;

void readStepper(JsonFields stepper, Calibration& c) {
    c.mountRpyDeg = stepper.vector("mount_rpy_deg", c.mountRpyDeg, kAngle);
    c.mountM = stepper.vector("mount_m", c.mountM, {-2, 2});
    c.axis = stepper.vector("axis", c.axis, {-1e3, 1e3});
    if (!(c.axis.norm() > 1e-6)) stepper.refuse("axis", "has no direction");
    c.degPerStep = stepper.number("step_deg", c.degPerStep, {1e-4, 10});
    c.zeroDeg = stepper.number("zero_deg", c.zeroDeg, kAngle);
    c.direction = stepper.number("direction", c.direction, {-1, 1});
    if (std::abs(c.direction) != 1.0) stepper.refuse("direction", "must be 1 or -1");
    c.mirrorIndexDeg = stepper.number("mirror_index_deg", c.mirrorIndexDeg, kAngle);
    stepper.done();
}

void readInclinometer(JsonFields inclinometer, Calibration& c) {
    c.viewing = static_cast<Viewing>(inclinometer.choice("viewing", kViewings));
    // Numbers that would not be used are refused, because they would mislead the reader of the file.
    if (c.viewing == Viewing::Rpy)
        c.viewingRpyDeg = inclinometer.neededVector("rpy_deg", kAngle);
    else if (inclinometer.has("rpy_deg"))
        inclinometer.refuse("rpy_deg", "needs \"viewing\": \"rpy\"");
    if (c.viewing == Viewing::Matrix)
        c.viewingMatrix = inclinometer.rotation("matrix");
    else if (inclinometer.has("matrix"))
        inclinometer.refuse("matrix", "needs \"viewing\": \"matrix\"");
    c.inclinometerM = inclinometer.vector("offset_m", c.inclinometerM, {-5, 5});
    c.tilt = static_cast<TiltReading>(inclinometer.choice("reads", kTilts));
    inclinometer.done();
}

void readBoom(JsonFields boom, Calibration& c) {
    c.slewAboutRobotZ = boom.choice("azimuth_about", kAzimuths) == 1;
    if (!boom.has("head_in_robot_m") && !boom.has("pivot_in_robot_m")) c.leftOut.emplace_back(kHeadKey);
    c.headInRobotM = boom.vector("head_in_robot_m", c.headInRobotM, kLever);
    if (boom.has("pivot_in_robot_m")) {
        if (boom.has("head_in_robot_m")) boom.refuse("pivot_in_robot_m", "and \"head_in_robot_m\" exclude each other");
        c.headInRobotM = boom.neededVector("pivot_in_robot_m", kLever);
        c.armM = boom.neededVector("arm_m", kLever);
    } else if (boom.has("arm_m")) {
        boom.refuse("arm_m", "needs \"pivot_in_robot_m\"");
    }
    boom.done();
}

} // namespace

Result<Calibration> parseCalibration(std::string_view json, const std::string& where) {
    const auto object = parseJsonObject(json, kCalibrationFormat, where);
    if (!object) return object.error();
    JsonFields fields(*object, where, "compare it with the example in docs/reference/coordinates.md");
    Calibration c;
    c.robot = fields.text("robot");
    readStepper(fields.object("stepper"), c);
    readInclinometer(fields.object("inclinometer"), c);
    readBoom(fields.object("boom"), c);
    JsonFields talin = fields.object("talin");
    if (!talin.has("in_robot_m")) c.leftOut.emplace_back("talin.in_robot_m");
    if (!talin.has("boresight_rpy_deg")) c.leftOut.emplace_back("talin.boresight_rpy_deg");
    c.talinInRobotM = talin.vector("in_robot_m", c.talinInRobotM, kLever);
    c.boresightRpyDeg = talin.vector("boresight_rpy_deg", c.boresightRpyDeg, kAngle);
    talin.done();
    JsonFields grid = fields.object("grid");
    if (!grid.has("convergence_deg")) c.leftOut.emplace_back(kConvergenceKey);
    c.convergenceDeg = grid.number("convergence_deg", c.convergenceDeg, physical::kRollDeg.limits);
    c.gridScale = grid.number("scale", c.gridScale, {0.99, 1.01});
    grid.done();
    JsonFields limits = fields.object("limits");
    c.tiltChangeLimitDeg = limits.number("tilt_change_deg", c.tiltChangeLimitDeg, {0, 90});
    c.poseAgeLimitS = limits.number("pose_age_s", c.poseAgeLimitS, {0, 1e9});
    limits.done();
    static_cast<void>(fields.value("estimated")); // says how the stepper's numbers were estimated: information for people, not used here
    fields.done();
    if (fields.problem()) return *fields.problem();
    return c;
}

Result<Calibration> openCalibration(const std::filesystem::path& path) {
    const auto bytes = readInput(path);
    if (!bytes) return bytes.error();
    return parseCalibration(textOf(*bytes), path.string());
}

RigidTransform inclinometerFromAxisBase(const Calibration& c) {
    Matrix3d rotation = c.viewingMatrix;
    if (c.viewing == Viewing::Forward) rotation << 0, 0, 1, -1, 0, 0, 0, -1, 0;
    if (c.viewing == Viewing::Up) rotation << 0, 1, 0, -1, 0, 0, 0, 0, 1;
    if (c.viewing == Viewing::Down) rotation << 0, 1, 0, 1, 0, 0, 0, 0, -1;
    if (c.viewing == Viewing::Rpy) rotation = rotationRpyDeg(c.viewingRpyDeg);
    return {rotation, c.inclinometerM};
}

StepperMount stepperMount(const Calibration& c) { return {moverFromSensor(c.mountRpyDeg, c.mountM), c.axis, c.zeroDeg, c.direction}; }

std::optional<Boom> boomOf(const Calibration& c) {
    if (c.armM.isZero(0.0)) return std::nullopt;
    const RigidTransform fromInclinometer = inverse(inclinometerFromAxisBase(c)); // the origin of this frame is the head
    return Boom{fromInclinometer * Eigen::Vector3d(-c.armM), fromInclinometer.translationM};
}

} // namespace edgescan
