// Scans that this program saved as points.
#pragma once

#include "core/files/point_tables/point_table.h"

namespace edgescan::files {

/// The table's description, ranges and states as the scan they were: every cell in order, bit-exact. Error: they do not fit each other.
Result<Scan> ownScan(PointTable table, const Source& source);

} // namespace edgescan::files
