// A line of a survey as a surveyor writes it: easting, northing, level, and what else it may hold.
#pragma once

#include "core/base/result.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace edgescan {

/// Which of the two comes first in a line without letters.
enum class SurveyOrder : std::uint8_t { EastingFirst, NorthingFirst };

struct SurveyLine {
    std::string name;     ///< of the point; empty if the line has none
    Eigen::Vector3d enhM; ///< Easting, Northing, Elevation
    std::optional<double> headingDeg;
    std::optional<double> pitchDeg, rollDeg;
};

/// Numbers are separated by semicolons, tabs, commas or blanks; a comma may be a decimal comma where something else separates. A name of
/// the point may come first, words after the numbers are left out. Letters before numbers ("N 5150123.4 E=498765.4 RL 287.6") give their
/// order themselves. After the three numbers a heading may follow, and after it pitch and roll. Error: another count of numbers, or a count
/// or a comma ("312,345.678") that allows two readings.
Result<SurveyLine> parseSurveyLine(std::string_view text, SurveyOrder order = SurveyOrder::EastingFirst);

/// Exactly `count` numbers, separated as above; empty if the text holds anything else.
[[nodiscard]] std::vector<double> typedNumbers(std::string_view text, std::size_t count);

} // namespace edgescan
