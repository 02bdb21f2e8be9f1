// Makes text of files, names and devices fit for a terminal, a log or a label. Escape sequences, line breaks, characters that change the
// direction of the text, and texts of 100 kB have no effect.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace edgescan {

inline constexpr std::size_t kMostShown = 1000; ///< characters in one line

/// One line of valid UTF-8. Control characters become \n, \t or \x1b. Invisible characters and those that change the direction of the text
/// become \u202e or similar. Bytes that are not UTF-8 become \xff. The middle of a longer text is replaced by the number of characters left
/// out.
[[nodiscard]] std::string printable(std::string_view text, std::size_t mostCharacters = kMostShown);

/// The same for each line of a text of several lines that EdgeScan itself wrote.
[[nodiscard]] std::string printableLines(std::string_view text);

/// The numbers of the characters; U+FFFD for a byte that is not UTF-8.
[[nodiscard]] std::vector<std::uint32_t> charactersOf(std::string_view text);

/// Any bytes, such as a file name, as valid UTF-8 without loss (docs/reference/command-line.md, "Names that are not UTF-8"). Valid UTF-8
/// stays as it is. Any other byte becomes the character U+EF00 + byte (U+EF80 to U+EFFF, private use). The three bytes of such a character
/// in `bytes` are written the same way, so that different bytes never give the same text.
[[nodiscard]] std::string escapedBytes(std::string_view bytes);

/// The bytes that escapedBytes() made the text of.
[[nodiscard]] std::string unescapedBytes(std::string_view text);

/// Printable JSON text: the same values, but every character that printable() would replace and every character of a byte is written
/// as \u001b or \uefff.
[[nodiscard]] std::string printableJson(std::string_view json);

/// JSON text of the same values that a spreadsheet never reads as a formula, wherever the spreadsheet splits it into cells: = and @ in
/// strings are written as \u003d and \u0040, and so are + and - where a cell could begin.
[[nodiscard]] std::string jsonWithoutFormulas(std::string_view json);

} // namespace edgescan
