// Lines of a text of numbers cut into words and cells. For what finds out how a text is laid out, and for readers of lines.
#pragma once

#include "core/files/point_tables/text_layout.h"

#include <charconv>
#include <string_view>
#include <vector>

namespace edgescan::files {

[[nodiscard]] std::string_view trimmed(std::string_view text);

/// A number as from_chars reads it, with a sign and with what old Microsoft programs append.
[[nodiscard]] bool isNumber(std::string_view word);

/// As std::from_chars, where the exponent is written as Fortran does: 1.5D+03. Not for hexadecimal numbers, which no table has.
std::from_chars_result numberWithFortranExponent(const char* from, const char* to, double& value);

/// Words between any of blank, comma, semicolon.
[[nodiscard]] std::vector<std::string_view> wordsIn(std::string_view line);

/// Numbers and marks of missing ones, at least one number among them.
[[nodiscard]] bool isRowOfNumbers(std::string_view line);

/// Nothing but separators, blanks and marks of missing numbers, and at least two cells.
[[nodiscard]] bool isEmptyRow(std::string_view line);

/// Where the cell that begins at `from` ends: at the next separator or at `to`. Separators within quotes belong to the cell.
[[nodiscard]] const char* endOfCell(const char* from, const char* to, char separator);

/// The text between the separators of a layout, a label included; without the last separator where no cell follows it.
[[nodiscard]] std::vector<std::string_view> cellsIn(std::string_view line, const TextLayout& layout);

/// The text before the first row of numbers.
struct TextHead {
    std::size_t firstByte = 0;
    std::size_t firstLine = 0;
    std::string_view units;  ///< a row of them below the header, one per column
    std::string_view header; ///< last line that is neither blank nor numbers, comment sign removed
    std::optional<std::size_t> promisedRows;
    std::string description;
    std::optional<double> unitMm; ///< millimetres per number by a line of comment
    bool found = false;
};
/// `labels`: a row may begin with a word, with a separator behind it.
[[nodiscard]] TextHead readHead(std::string_view text, bool labels);

} // namespace edgescan::files
