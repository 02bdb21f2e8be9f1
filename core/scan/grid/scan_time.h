// When a scan was measured, from whatever states it.
#pragma once

#include "core/scan/grid/scan.h"

#include <optional>

namespace edgescan {

/// The start in seconds since 1970 UTC, of a time that nanoseconds since 1970 can hold (core/base/utc_time.h): by the lines, by the scan's
/// own file, else by its pose file, which states the start of the scan or at least the time of the pose. Empty if unknown.
[[nodiscard]] std::optional<double> startOfScan(const Scan& scan);

} // namespace edgescan
