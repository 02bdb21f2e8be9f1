// The words by which headings name an axis, in the languages of mining, and the units next to them.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace edgescan::files {

/// Letters and digits of a heading between anything else, in lower case and without marks: "Höhe [m]" is "hoehe", "m". Letters of UTF-8 and
/// Latin-1; those of other scripts stay as they are.
[[nodiscard]] std::vector<std::string> headingWords(std::string_view text);

/// The same in one piece.
[[nodiscard]] std::string headingLetters(std::string_view text);

enum class AxisWord : std::uint8_t { East, North, Up };

/// The axis that a heading names by its words: "Mine North", "UTM_N", "Y_North", "Z-Koordinate". A point of the compass goes before a
/// letter. Words of `shared` say nothing. Empty: it names none, or several.
[[nodiscard]] std::optional<AxisWord> axisNamed(std::string_view heading, std::span<const std::string> shared = {});

/// Words that several headings have next to an axis, or joined with x, y or z: "Mina" of "Norte Mina" and "Este Mina". Without those that
/// say what was measured along the axes, such as "velocity" or "error".
[[nodiscard]] std::vector<std::string> wordsNextToAxes(std::span<const std::string> headings);

/// True where a heading has a word for an axis or for its opposite ("Southing"), whatever its other words are.
[[nodiscard]] bool speaksOfAxis(std::string_view heading);

/// "azimuth (0.01 deg)" without the number before its unit.
struct ScaledHeading {
    std::string name;
    double factor = 1;
};
[[nodiscard]] ScaledHeading withoutFactor(std::string_view heading);

/// Millimetres per unit of a name in letters: "mm", "metres", "ussurveyfeet".
[[nodiscard]] std::optional<double> unitNamed(std::string_view letters);

/// Millimetres per unit where a line of comment says it: "units: feet", "coordinates in mm". Empty: it says none, or several.
[[nodiscard]] std::optional<double> unitInComment(std::string_view comment);

} // namespace edgescan::files
