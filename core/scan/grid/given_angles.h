// Angles and mounting that the operator gives when opening a scan. They override values from the file and values that EdgeScan recognised.
#pragma once

#include "core/scan/grid/reading_options.h"

namespace edgescan {

/// Sets lines and beams to the given angles, as far as they are given. A warning reports an angle that differs from the file's, and one
/// that has no effect because the scan is an organised cloud.
void applyGivenAngles(Scan& scan, const ReadingOptions& options);

} // namespace edgescan
