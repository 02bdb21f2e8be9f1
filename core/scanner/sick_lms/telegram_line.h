// From a telegram of the scanner to the scan line of a sweep.
#pragma once

#include "core/scanner/sick_lms/scan_telegram.h"
#include "core/scanner/sweep_assembly/sweep_settings.h"

namespace edgescan::scanner {

/// The telegram's counters and clocks.
[[nodiscard]] LineCount countOf(const ScanTelegram& telegram);

/// The line in a telegram: ranges of the requested echo, beams, counters, device status.
[[nodiscard]] SweepLine sweepLine(const ScanTelegram& telegram, Echo echo);

} // namespace edgescan::scanner
