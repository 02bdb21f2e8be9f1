// Writes the result of the self-calibration as a robot's calibration file (docs/reference/coordinates.md, "Calibration").
#pragma once

#include "app/lab/calibration/self_calibration.h"

#include <nlohmann/json.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace edgescan::inspect {

/// A scan used for the estimate: its name and the SHA-256 of its file.
struct CalibrationSource {
    std::string name, sha256;
};

/// The estimated errors with their uncertainty, units in the keys, null for errors that were not estimated: the object "estimated" of the
/// file, and the report in the window.
[[nodiscard]] nlohmann::ordered_json estimateJson(const SelfCalibration& found, const std::vector<CalibrationSource>& sources);

/// The whole file. `base`: text of the robot's present file; its stepper is replaced and all else is unchanged. Empty: the file gets only
/// the stepper. Error: `base` (named `where`) is not a calibration, or its stepper has another axis.
Result<std::string> calibrationText(std::string_view base, const std::string& where, const SelfCalibration& found,
                                    const std::vector<CalibrationSource>& sources);

} // namespace edgescan::inspect
