// A coarse scan: every n-th line and every n-th beam of another one.
#pragma once

#include "core/scan/grid/scan.h"

namespace edgescan {

/// From line 0 and beam 0 on. Its cells have the ranges, states and points of `scan`; without attached points, warnings and names.
[[nodiscard]] Scan everyNth(const Scan& scan, int n);

} // namespace edgescan
