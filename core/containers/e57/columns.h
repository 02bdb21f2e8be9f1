// The points of an E57 scan, column by column: packets, byte streams and packed bits (ASTM E2807, "CompressedVector").
#pragma once

#include "core/containers/e57/file.h"

#include <functional>

namespace edgescan::containers {

/// The numbers of these columns of a scan, `scan.points` each. `goOn` gets the share that is done and cancels with false. Error: cancelled,
/// damaged, fewer than promised, or more than a file of this size can hold.
Result<std::vector<std::vector<double>>> readE57Columns(E57File& file, const E57Scan& scan, const std::vector<std::size_t>& columns,
                                                        const std::function<bool(double)>& goOn);

} // namespace edgescan::containers
