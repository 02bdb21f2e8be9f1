// What a turn told, as a robot's calibration file (docs/coordinates.md, "Calibration").
#pragma once

#include "core/inspect/calibration/self_calibration.h"

#include <nlohmann/json.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace edgescan {

/// A scan that was used: its name and the SHA-256 of its file.
struct CalibrationSource {
    std::string name, sha256;
};

/// The errors found with their uncertainty, units in the keys, null for what is not told: the object "estimated" of the file, and the
/// report on the screen.
[[nodiscard]] nlohmann::ordered_json estimateJson(const SelfCalibration& found, const std::vector<CalibrationSource>& sources);

/// The whole file. `base`: text of the robot's present file, whose stepper is set anew and all else stays; empty: a file with nothing but
/// the stepper. Error: `base` (named `where`) is no calibration, or of a stepper that turns about another axis.
Result<std::string> calibrationText(std::string_view base, const std::string& where, const SelfCalibration& found,
                                    const std::vector<CalibrationSource>& sources);

} // namespace edgescan
