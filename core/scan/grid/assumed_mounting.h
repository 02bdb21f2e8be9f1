// Whether the shape of a scan depends on a mounting that was not given.
#pragma once

#include "core/scan/grid/scan.h"

#include <algorithm>

namespace edgescan {

inline constexpr const char* kMountingAssumed = "How a motor turned the scanner was not said. ASSUMED: "; ///< begins the scan's warning
inline constexpr const char* kAxisAssumed = "the axis (";                   ///< of that sentence, if the axis was not given
inline constexpr const char* kStepAssumed = "the step from line to line ("; ///< and before the degrees of a step not given

/// Ranges are measured in any case; lengths between cells, sizes and coordinates are right only if the assumption is.
[[nodiscard]] inline bool mountingAssumed(const Scan& scan) {
    return std::ranges::any_of(scan.warnings, [](const std::string& warning) { return warning.starts_with(kMountingAssumed); });
}

} // namespace edgescan
