// Numbers whose thousands are set apart, as spreadsheets print them: 402 100,25 or 402.100,25 or 402'100.25. They are refused: a blank, a
// point or a comma among digits may as well be the end of a number.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace edgescan::files {

/// Bytes of a row that is cut up to see what is wrong: of a longer one the cells would take more memory than the file.
inline constexpr std::size_t kLongestRowLookedAt = 1U << 16U;

/// Maybe: one comma or point before three last digits, which may be decimals.
enum class Grouped : std::uint8_t { No, Maybe, Yes };

/// Whether a cell is one number whose thousands are set apart by blanks (also those that do not break), apostrophes, points or commas.
[[nodiscard]] Grouped groupsOf(std::string_view cell);

/// The first such number among the rows of a text.
struct GroupedNumber {
    std::string word;
    std::size_t line = 1;       ///< of the text, from 1
    bool mayBeDecimals = false; ///< a column of numbers with three decimals and numbers without: either reading is possible
};
/// Looks at the first rows, cut at semicolons or tabs, else at commas outside quotes, else at blanks. Rows have three numbers at least.
[[nodiscard]] std::optional<GroupedNumber> findGroupedNumber(std::string_view text);

} // namespace edgescan::files
