// The rows of a run as tables, in the order of its inputs (docs/batch.md, "The table").
#pragma once

#include <string>
#include <vector>

namespace edgescan {

/// One line of JSON per row, as the journal holds it but for what only the journal needs.
[[nodiscard]] std::string ndjsonTable(const std::vector<std::string>& rows);

/// A header and one line per row (RFC 4180). Text that a spreadsheet would take for a formula has an apostrophe before it; what times say
/// stands in the last columns, whose names begin with "time_".
[[nodiscard]] std::string csvTable(const std::vector<std::string>& rows);

} // namespace edgescan
