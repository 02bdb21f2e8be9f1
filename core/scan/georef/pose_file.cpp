// Reads pose files.
#include "core/base/translated_text.h"
#include "core/scan/georef/place_scan.h"

#include "core/base/inputs.h"
#include "core/base/json_fields.h"
#include "core/base/json_text.h"
#include "core/base/whole_file.h"
#include "core/scan/georef/calibration.h"

#include <cmath>

namespace edgescan {
namespace {

constexpr const char* kPoseFormat = "edgescan-pose/1";
constexpr const char* kPoseHint = "compare it with the example in docs/reference/coordinates.md";
constexpr NumberLimits kTilt = physical::kTiltDeg.limits;
constexpr NumberLimits kPlace = physical::kPlaceM.limits;
constexpr NumberLimits kPoseAngle = physical::kBeamDeg.limits;
constexpr double kDegPerMil = 360.0 / 6400.0;

/// NAME_deg, or NAME_mil with 6400 mils to the full turn, a unit that TALIN can be set to.
double angle(JsonFields& fields, const std::string& name, NumberLimits limits) {
    const std::string deg = name + "_deg";
    const std::string mil = name + "_mil";
    const bool inDegrees = fields.has(deg.c_str());
    if (!fields.has(mil.c_str())) return fields.neededNumber(deg.c_str(), limits);
    if (inDegrees) fields.refuse(deg, withValues("and \"%1\" exclude each other", {mil}));
    return fields.number(mil.c_str(), 0, {limits.least / kDegPerMil, limits.most / kDegPerMil}) * kDegPerMil;
}

InclinometerReading readInclinometer(JsonFields fields) {
    InclinometerReading reading;
    reading.timeS = fields.time("time");
    reading.tiltXDeg = fields.neededNumber("tilt_x_deg", kTilt);
    reading.tiltYDeg = fields.neededNumber("tilt_y_deg", kTilt);
    fields.done();
    return reading;
}

TalinReading readTalin(JsonFields fields, PoseTrack& poses) {
    TalinReading reading;
    reading.timeS = fields.time("time");
    reading.enhM = {fields.neededNumber("easting_m", kPlace), fields.neededNumber("northing_m", kPlace),
                    fields.neededNumber("elevation_m", physical::kElevationM.limits)};
    reading.headingDeg = angle(fields, "heading", kPoseAngle);
    reading.pitchDeg = angle(fields, "pitch", kTilt);
    reading.rollDeg = angle(fields, "roll", physical::kRollDeg.limits);
    reading.trueNorth = fields.choice("heading_ref", {"true", "grid"}) == 0;
    const std::string zone = fields.text("zone");
    const std::string datum = fields.text("datum");
    if (poses.grid.empty()) poses.grid = zone + (zone.empty() || datum.empty() ? "" : ", ") + datum;
    fields.done();
    return reading;
}

template <class Reading>
void checkTimes(JsonFields& fields, const std::vector<Reading>& readings, const char* key, bool moving) {
    if (readings.empty()) return fields.refuse(key, "is missing");
    for (std::size_t i = 0; i < readings.size(); ++i) {
        if (moving && std::isnan(readings[i].timeS))
            return fields.refuse(key, "needs a \"time\" in every reading when \"sweep\" is \"moving\"");
        if (i > 0 && readings[i].timeS <= readings[i - 1].timeS) return fields.refuse(key, "must be in the order of time");
    }
}

} // namespace

Result<PoseTrack> parsePoses(std::string_view json, const std::string& where) {
    const auto object = parseJsonObject(json, kPoseFormat, where);
    if (!object) return object.error();
    JsonFields fields(*object, where, kPoseHint);
    PoseTrack poses;
    poses.source = std::filesystem::path(where).filename().string();
    poses.robot = fields.text("robot");
    poses.scanStartS = fields.time("scan_start");
    poses.scanEndS = fields.time("scan_end");
    if (poses.scanEndS < poses.scanStartS) fields.refuse("scan_end", "comes before \"scan_start\"");
    poses.moving = fields.choice("sweep", {"static", "moving"}) == 1;
    JsonFields boom = fields.object("boom");
    poses.boomAzimuthDeg = boom.neededNumber("azimuth_deg", kPoseAngle);
    poses.headInRobotM = boom.vector("head_in_robot_m", poses.headInRobotM, physical::kLeverM.limits);
    boom.done();
    for (const JsonFields& reading : fields.objects("inclinometer")) poses.inclinometer.push_back(readInclinometer(reading));
    for (const JsonFields& reading : fields.objects("talin")) poses.talin.push_back(readTalin(reading, poses));
    if (const nlohmann::json& robot = fields.value("calibration"); !robot.is_null()) {
        auto calibration = parseCalibration(jsonText(robot), where);
        if (!calibration) return calibration.error();
        poses.calibration = std::move(*calibration);
    }
    checkTimes(fields, poses.inclinometer, "inclinometer", poses.moving);
    checkTimes(fields, poses.talin, "talin", poses.moving);
    fields.done();
    if (fields.problem()) {
        Error problem = *fields.problem();
        const std::string key = problem.what.substr(0, problem.what.find(' '));
        if (key.find("roll") != std::string::npos || key.find("viewing") != std::string::npos)
            problem.hint += "; a scanner that hangs has \"viewing\": \"down\" in its calibration";
        if (key.find("heading_ref") != std::string::npos) problem.hint += "; a magnetic bearing is converted as the same page says";
        return problem;
    }
    return poses;
}

Result<PoseTrack> openPoses(const std::filesystem::path& path) {
    const auto bytes = readInput(path);
    if (!bytes) return bytes.error();
    if (path.extension() == ".pose" && textOf(*bytes).find('{') == std::string_view::npos)
        return Error{"this is a pose of 3DTK and not of EdgeScan", path.string(), "give a pose file as in docs/reference/coordinates.md"};
    return parsePoses(textOf(*bytes), path.string());
}

} // namespace edgescan
