// Scans that this program saved as points.
#pragma once

#include "core/files/point_tables/point_table.h"

namespace edgescan::files {

/// The table's description, ranges and states as the scan they were. Error: they do not fit each other.
Result<Scan> ownScan(PointTable& table, const Source& source);

/// Whether ranges and states are all that ownScan() takes of a table with this description, because its angles say the rest: then x y z,
/// line and beam need not be kept.
[[nodiscard]] bool takesRangesOnly(const std::string& description);

} // namespace edgescan::files
