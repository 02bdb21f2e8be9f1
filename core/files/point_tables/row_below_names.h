// Headings of texts: the names in them, and the first row below.
#pragma once

#include "core/files/point_tables/column_names.h"
#include "core/files/point_tables/text_layout.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace edgescan::files {

/// Rows at the beginning of a text that are looked at to find out how it is laid out.
inline constexpr std::size_t kSampleRows = 20;

/// The names in a heading, in lower case; a unit in separate brackets belongs to the name before it.
[[nodiscard]] std::vector<std::string> namesIn(std::string_view header, const TextLayout& layout);

struct RowBelowNames {
    std::vector<std::string> names; ///< of the heading, lower case
    NamedColumns named;             ///< x, y and z among them
    std::vector<std::string_view> cells;
    std::size_t firstByte = 0; ///< where the row begins
    std::size_t firstLine = 0; ///< its number, from 1
};

/// The first row of cells below a heading that names x, y and z between such separators; empty: not among the first kSampleRows lines.
/// Rows beyond kLongestRowLookedAt bytes are passed over. The text must outlive the cells.
[[nodiscard]] std::optional<RowBelowNames> rowBelowNames(std::string_view text, char separator);

} // namespace edgescan::files
