// The robot's settings file.
#include "core/georef/calibration.h"

#include "core/base/json_fields.h"
#include "core/base/whole_file.h"
#include "core/georef/chain.h"
#include "core/georef/rotations.h"

#include <cmath>

namespace edgescan {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Json = nlohmann::ordered_json;

constexpr const char* kCalibrationFormat = "edgescan-calibration/1";
const std::vector<std::string> kViewings{"forward", "up", "rpy", "matrix"};
const std::vector<std::string> kTilts{"elevations", "pitch_roll"};
const std::vector<std::string> kAzimuths{"vertical", "robot_z"};
constexpr NumberLimits kLever{-100, 100}; // metres: nothing on a robot is farther away

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
    // Numbers that would not be used are refused: they would mislead whoever reads the file.
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

Json vectorJson(const Vector3d& v) { return {v.x(), v.y(), v.z()}; }

Json matrixJson(const Matrix3d& m) {
    Json rows = Json::array();
    for (int i = 0; i < 3; ++i) rows.push_back({m(i, 0), m(i, 1), m(i, 2)});
    return rows;
}

/// JSON by hand: one line per key, lists on it, so that a person sees the table.
std::string readable(const Json& object) {
    std::string text = "{\n";
    std::size_t left = object.size();
    for (const auto& [key, value] : object.items()) {
        text += "  " + Json(key).dump() + ": ";
        if (value.is_object()) {
            text += "{\n";
            std::size_t inner = value.size();
            for (const auto& [name, item] : value.items())
                text += "    " + Json(name).dump() + ": " + item.dump() + (--inner > 0 ? ",\n" : "\n");
            text += "  }";
        } else {
            text += value.dump();
        }
        text += --left > 0 ? ",\n" : "\n";
    }
    return text + "}\n";
}

} // namespace

bool operator==(const Calibration& a, const Calibration& b) { return calibrationText(a) == calibrationText(b); }

Result<Calibration> parseCalibration(std::string_view json, const std::string& where) {
    const auto object = parseJsonObject(json, kCalibrationFormat, where);
    if (!object) return object.error();
    JsonFields fields(*object, where, "compare it with the example in docs/coordinates.md");
    Calibration c;
    c.robot = fields.text("robot");
    readStepper(fields.object("stepper"), c);
    readInclinometer(fields.object("inclinometer"), c);
    readBoom(fields.object("boom"), c);
    JsonFields talin = fields.object("talin");
    c.talinInRobotM = talin.vector("in_robot_m", c.talinInRobotM, kLever);
    c.boresightRpyDeg = talin.vector("boresight_rpy_deg", c.boresightRpyDeg, kAngle);
    talin.done();
    JsonFields grid = fields.object("grid");
    c.convergenceDeg = grid.number("convergence_deg", c.convergenceDeg, {-180, 180});
    c.gridScale = grid.number("scale", c.gridScale, {0.99, 1.01});
    grid.done();
    JsonFields limits = fields.object("limits");
    c.tiltChangeLimitDeg = limits.number("tilt_change_deg", c.tiltChangeLimitDeg, {0, 90});
    c.poseAgeLimitS = limits.number("pose_age_s", c.poseAgeLimitS, {0, 1e9});
    limits.done();
    fields.done();
    if (fields.problem()) return *fields.problem();
    return c;
}

Result<Calibration> openCalibration(const std::filesystem::path& path) {
    const auto bytes = readWholeFile(path);
    if (!bytes) return bytes.error();
    return parseCalibration({reinterpret_cast<const char*>(bytes->data()), bytes->size()}, path.string());
}

std::string calibrationText(const Calibration& c) {
    Json stepper{{"mount_rpy_deg", vectorJson(c.mountRpyDeg)},
                 {"mount_m", vectorJson(c.mountM)},
                 {"axis", vectorJson(c.axis)},
                 {"step_deg", c.degPerStep},
                 {"zero_deg", c.zeroDeg},
                 {"direction", c.direction},
                 {"mirror_index_deg", c.mirrorIndexDeg}};
    Json inclinometer{{"viewing", kViewings[static_cast<std::size_t>(c.viewing)]}};
    if (c.viewing == Viewing::Rpy) inclinometer["rpy_deg"] = vectorJson(c.viewingRpyDeg);
    if (c.viewing == Viewing::Matrix) inclinometer["matrix"] = matrixJson(c.viewingMatrix);
    inclinometer["offset_m"] = vectorJson(c.inclinometerM);
    inclinometer["reads"] = kTilts[static_cast<std::size_t>(c.tilt)];
    Json boom{{"azimuth_about", kAzimuths[c.slewAboutRobotZ ? 1 : 0]}};
    const bool arm = !c.armM.isZero(0.0);
    boom[arm ? "pivot_in_robot_m" : "head_in_robot_m"] = vectorJson(c.headInRobotM);
    if (arm) boom["arm_m"] = vectorJson(c.armM);
    return readable({{"format", kCalibrationFormat},
                     {"robot", c.robot},
                     {"stepper", stepper},
                     {"inclinometer", inclinometer},
                     {"boom", boom},
                     {"talin", {{"in_robot_m", vectorJson(c.talinInRobotM)}, {"boresight_rpy_deg", vectorJson(c.boresightRpyDeg)}}},
                     {"grid", {{"convergence_deg", c.convergenceDeg}, {"scale", c.gridScale}}},
                     {"limits", {{"tilt_change_deg", c.tiltChangeLimitDeg}, {"pose_age_s", c.poseAgeLimitS}}}});
}

Calibration exampleCalibration() {
    Calibration c;
    c.robot = "example robot";
    c.mountRpyDeg = {0.2, -0.1, 0.15};
    c.mountM = {0.0015, 0.004, 0.035};
    c.headInRobotM = {4.2, 1.3, 2.65};
    c.talinInRobotM = {-0.85, 0.1, 1.15};
    c.boresightRpyDeg = {0.05, -0.08, 0.12};
    c.convergenceDeg = -0.35;
    return c;
}

RigidTransform inclinometerFromAxisBase(const Calibration& c) {
    Matrix3d rotation = c.viewingMatrix;
    if (c.viewing == Viewing::Forward) rotation << 0, 0, 1, -1, 0, 0, 0, -1, 0;
    if (c.viewing == Viewing::Up) rotation << 0, 1, 0, -1, 0, 0, 0, 0, 1;
    if (c.viewing == Viewing::Rpy) rotation = rotationRpyDeg(c.viewingRpyDeg);
    return {rotation, c.inclinometerM};
}

StepperMount stepperMount(const Calibration& c) { return {moverFromSensor(c.mountRpyDeg, c.mountM), c.axis, c.zeroDeg, c.direction}; }

} // namespace edgescan
