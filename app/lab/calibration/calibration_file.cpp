// Writes the calibration file.
#include "app/lab/calibration/calibration_file.h"

#include "core/base/bounded_json.h"
#include "core/base/json_text.h"
#include "core/base/number_text.h"
#include "core/base/version.h"
#include "core/scan/georef/calibration.h"

#include <cmath>

namespace edgescan::inspect {
namespace {

using Json = nlohmann::ordered_json;

Json errorsJson(const AssemblyErrors& e, bool turnTold) {
    constexpr double kMm = 1e3, kDeg = 1e5;
    return {{"t1_mm", rounded(e.t1Mm(), kMm)},
            {"t2_mm", rounded(e.t2Mm(), kMm)},
            {"tilt_deg", rounded(e.tiltDeg(), kDeg)},
            {"index_deg", rounded(e.indexDeg(), kDeg)},
            {"turn_deg", turnTold ? Json(rounded(e.turnDeg(), kDeg)) : Json(nullptr)}};
}

Json vectorJson(const Eigen::Vector3d& v) {
    constexpr double kDigits = 1e6; // a micrometre, a millionth of a degree
    return {rounded(v.x(), kDigits), rounded(v.y(), kDigits), rounded(v.z(), kDigits)};
}

} // namespace

Json estimateJson(const SelfCalibration& found, const std::vector<CalibrationSource>& sources) {
    Json scans = Json::array();
    for (const CalibrationSource& source : sources) scans.push_back({{"name", source.name}, {"sha256", source.sha256}});
    return {{"errors", errorsJson(found.errors, found.turnIsEstimated)},
            {"one_sd", errorsJson(found.sd, found.turnIsEstimated)},
            {"overlap_deg", rounded(found.overlapDeg, 1e3)},
            {"cells", found.cells},
            {"views_apart_before_mm", rounded(found.medianBeforeMm, 1e2)},
            {"views_apart_after_mm", rounded(found.medianAfterMm, 1e2)},
            {"explained_by_noise_mm", rounded(found.noiseMm, 1e2)},
            {"scans", scans},
            {"program", "edgescan " + std::string(version())}};
}

Result<std::string> calibrationText(std::string_view base, const std::string& where, const SelfCalibration& found,
                                    const std::vector<CalibrationSource>& sources) {
    Calibration before;
    Json json{{"format", "edgescan-calibration/1"}, {"robot", ""}};
    if (!base.empty()) {
        const auto parsed = parseCalibration(base, where);
        if (!parsed) return parsed.error();
        before = *parsed;
        const auto ordered = parseOrderedJson(base, where);
        if (!ordered) return ordered.error();
        json = *ordered;
        const Eigen::Vector3d axis = before.axis.normalized();
        if (std::abs(found.axis == Axis::Spin ? axis.z() : axis.x()) < 0.9)
            return Error{"its stepper turns about another axis than that of the scan", where, "give the file of the robot that scanned"};
    }
    const Calibration after = withAssembly(before, found.axis, found.errors);
    Json& stepper = json["stepper"];
    stepper["mount_rpy_deg"] = vectorJson(after.mountRpyDeg);
    stepper["mount_m"] = vectorJson(after.mountM);
    if (!stepper.contains("axis")) stepper["axis"] = vectorJson(after.axis);
    if (found.turnIsEstimated) stepper["step_deg"] = rounded(after.degPerStep, 1e8);
    json["estimated"] = estimateJson(found, sources);
    return jsonText(json, 2) + "\n";
}

} // namespace edgescan::inspect
