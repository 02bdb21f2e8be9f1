// Checks whether the free memory is enough for work on an open scan.
#pragma once

#include "core/base/result.h"
#include "core/scan/grid/scan.h"

#include <cstdint>

namespace edgescan::edges {

enum class Work : std::uint8_t { Detect, Explain, Compare, Rocks, StoreFolds };

/// Call it before the work begins. Error: the scan has too many cells for the free memory.
Result<Done> checkMemoryFor(Work work, const Scan& scan);

} // namespace edgescan::edges
