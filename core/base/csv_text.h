// The text cells of every CSV that EdgeScan writes.
#pragma once

#include <string>
#include <string_view>

namespace edgescan {

/// A cell (RFC 4180) that a spreadsheet never computes, whether it separates cells at commas, semicolons, bars or tabs: an apostrophe is
/// written before each = + - @ with which a cell could begin. A finite number stays as it is. Control characters are written as printable()
/// does, and bytes that are not UTF-8 as escapedBytes() does.
[[nodiscard]] std::string csvCell(std::string_view text);

} // namespace edgescan
