// The ranges of a scan as a 16-bit picture.
#pragma once

#include "core/scan/grid/scan.h"

namespace edgescan {

/// lines x beams, whole millimetres; 0 where there is no valid range, 65535 for all larger ranges.
[[nodiscard]] Grid<std::uint16_t> rangePicture(const Scan& scan);

} // namespace edgescan
