// Whether the memory suffices for what is done with a scan that was opened.
#pragma once

#include "core/base/result.h"
#include "core/scan/grid/scan.h"

#include <cstdint>

namespace edgescan {

enum class Work : std::uint8_t { Detect, Explain, Compare, Rocks };

/// Asked before the work begins. Error: the scan has too many cells for the memory that is free.
Result<Done> checkMemoryFor(Work work, const Scan& scan);

} // namespace edgescan
