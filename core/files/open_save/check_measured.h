// Whether the numbers of a scan can have been measured, whichever reader they came through.
#pragma once

#include "core/base/result.h"
#include "core/scan/grid/scan.h"

#include <string>

namespace edgescan::files {

/// Error: a valid range, an angle, the unit or the place leaves the table of core/base/physical_limits.h, or all beams look the same way.
/// `where` is the path.
Result<Done> checkMeasured(const Scan& scan, const std::string& where);

} // namespace edgescan::files
