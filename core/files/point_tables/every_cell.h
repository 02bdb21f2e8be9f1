// All cells of a scan as a cloud whose columns are made some lines at a time.
#pragma once

#include "core/files/point_tables/cloud_columns.h"

#include <optional>
#include <vector>

namespace edgescan::files {

inline constexpr double kLargestInFloat = 1e4; ///< metres; beyond it a 4-byte float steps by a millimetre and more

/// Whether 4-byte floats hold all coordinates: none is larger than its range.
[[nodiscard]] bool areWithinFloats(const std::vector<float>& rangesMm);

/// What everyCell() gives of a polar scan in the scanner's frame, by CloudColumns::linesLater and without a description; empty where that
/// is not all there is. The scan must outlive it.
[[nodiscard]] std::optional<CloudColumns> cellsByLines(const Scan& scan, CoordinateFrame frame);

} // namespace edgescan::files
