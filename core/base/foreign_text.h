// What comes from files, names and devices, made fit for a terminal, a log or a label: escape sequences, line breaks, writing that turns
// the direction of what follows, and 100 kB of text stay without effect.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace edgescan {

inline constexpr std::size_t kMostShown = 1000; ///< characters of one line

/// One line of valid UTF-8. Controls become \n, \t or \x1b, invisible characters and those that turn the direction of writing \u202e,
/// bytes that are no UTF-8 \xff; of a longer text the middle is left out, and how much of it is told.
[[nodiscard]] std::string printable(std::string_view text, std::size_t mostCharacters = kMostShown);

/// The same line by line: for a text of several lines of our own.
[[nodiscard]] std::string printableLines(std::string_view text);

/// JSON text that is printable: the same values, with every character that printable() would replace written as \u001b.
[[nodiscard]] std::string printableJson(std::string_view json);

/// JSON text of the same values that no spreadsheet takes for a formula, wherever it cuts it into cells: = and @ in strings are written as
/// \u003d and \u0040, and + and - where a cell could begin.
[[nodiscard]] std::string jsonWithoutFormulas(std::string_view json);

} // namespace edgescan
