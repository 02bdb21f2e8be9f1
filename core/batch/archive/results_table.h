// The rows of a run as tables, in the order of its inputs (docs/reference/batch.md, "The table").
#pragma once

#include <string>
#include <vector>

namespace edgescan::batch {

/// One line of JSON per row, as in the journal but without the values that only the journal needs.
[[nodiscard]] std::string ndjsonTable(const std::vector<std::string>& rows);

/// A header and one line per row (RFC 4180). Text is a csvCell() (core/base/csv_text.h). The last columns,
/// whose names begin with "time_", hold the times.
[[nodiscard]] std::string csvTable(const std::vector<std::string>& rows);

} // namespace edgescan::batch
