// Calibrations and poses as files written by a person would look, and a robot with typical values.
#pragma once

#include "core/base/utc_time.h"
#include "core/scan/georef/calibration.h"
#include "core/scan/georef/place_scan.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <string>

namespace edgescan {
namespace test {

using Json = nlohmann::ordered_json;

inline Json vectorJson(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

inline Json matrixJson(const Eigen::Matrix3d& m) {
    Json rows = Json::array();
    for (int i = 0; i < 3; ++i) rows.push_back({m(i, 0), m(i, 1), m(i, 2)});
    return rows;
}

/// JSON in a readable form: one line per key, with lists on one line.
inline std::string readable(const Json& object) {
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

/// {"format": "edgescan-calibration/1", ...} with every key; parseCalibration returns the same numbers.
inline std::string calibrationText(const Calibration& c) {
    Json stepper{{"mount_rpy_deg", vectorJson(c.mountRpyDeg)},
                 {"mount_m", vectorJson(c.mountM)},
                 {"axis", vectorJson(c.axis)},
                 {"step_deg", c.degPerStep},
                 {"zero_deg", c.zeroDeg},
                 {"direction", c.direction},
                 {"mirror_index_deg", c.mirrorIndexDeg}};
    Json inclinometer{{"viewing", std::array{"forward", "up", "down", "rpy", "matrix"}[static_cast<std::size_t>(c.viewing)]}};
    if (c.viewing == Viewing::Rpy) inclinometer["rpy_deg"] = vectorJson(c.viewingRpyDeg);
    if (c.viewing == Viewing::Matrix) inclinometer["matrix"] = matrixJson(c.viewingMatrix);
    inclinometer["offset_m"] = vectorJson(c.inclinometerM);
    inclinometer["reads"] = std::array{"elevations", "pitch_roll"}[static_cast<std::size_t>(c.tilt)];
    Json boom{{"azimuth_about", c.slewAboutRobotZ ? "robot_z" : "vertical"}};
    const bool arm = !c.armM.isZero(0.0);
    boom[arm ? "pivot_in_robot_m" : "head_in_robot_m"] = vectorJson(c.headInRobotM);
    if (arm) boom["arm_m"] = vectorJson(c.armM);
    return readable({{"format", "edgescan-calibration/1"},
                     {"robot", c.robot},
                     {"stepper", stepper},
                     {"inclinometer", inclinometer},
                     {"boom", boom},
                     {"talin", {{"in_robot_m", vectorJson(c.talinInRobotM)}, {"boresight_rpy_deg", vectorJson(c.boresightRpyDeg)}}},
                     {"grid", {{"convergence_deg", c.convergenceDeg}, {"scale", c.gridScale}}},
                     {"limits", {{"tilt_change_deg", c.tiltChangeLimitDeg}, {"pose_age_s", c.poseAgeLimitS}}}});
}

inline Calibration exampleCalibration() {
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

inline Json timeJson(double seconds) { return std::isnan(seconds) ? Json() : Json(utcText(seconds)); }

/// {"format": "edgescan-pose/1", ...}; parsePoses returns the same numbers (times to the millisecond).
inline std::string posesText(const PoseTrack& poses) {
    Json object{{"format", "edgescan-pose/1"},
                {"robot", poses.robot},
                {"scan_start", timeJson(poses.scanStartS)},
                {"scan_end", timeJson(poses.scanEndS)}};
    object["sweep"] = poses.moving ? "moving" : "static";
    object["boom"]["azimuth_deg"] = poses.boomAzimuthDeg;
    const Eigen::Vector3d& head = poses.headInRobotM;
    if (head.allFinite()) object["boom"]["head_in_robot_m"] = {head.x(), head.y(), head.z()};
    for (const InclinometerReading& r : poses.inclinometer)
        object["inclinometer"].push_back({{"time", timeJson(r.timeS)}, {"tilt_x_deg", r.tiltXDeg}, {"tilt_y_deg", r.tiltYDeg}});
    for (const TalinReading& r : poses.talin) {
        object["talin"].push_back({{"time", timeJson(r.timeS)},
                                   {"easting_m", r.enhM.x()},
                                   {"northing_m", r.enhM.y()},
                                   {"elevation_m", r.enhM.z()},
                                   {"heading_deg", r.headingDeg},
                                   {"heading_ref", r.trueNorth ? "true" : "grid"},
                                   {"pitch_deg", r.pitchDeg},
                                   {"roll_deg", r.rollDeg},
                                   {"zone", poses.grid}});
    }
    return object.dump(1) + "\n";
}

} // namespace test

inline bool operator==(const Calibration& a, const Calibration& b) { return test::calibrationText(a) == test::calibrationText(b); }

} // namespace edgescan
