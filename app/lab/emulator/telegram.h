// Converts a scan to the telegrams that an LMS511 would have sent while measuring it.
#pragma once

#include "core/base/result.h"
#include "core/scan/grid/scan.h"
#include "core/scanner/sick_lms/scan_telegram.h"

#include <cstdint>
#include <vector>

namespace edgescan::scanner {

struct TelegramStyle {
    std::uint32_t serialNumber = 18110550;
    std::uint32_t scanFrequency = 2500;  ///< 1/100 Hz
    std::uint16_t firstTelegram = 10203; ///< counters of line 0
    std::uint16_t firstScan = 10335;
    std::uint32_t firstUs = 1387959194; ///< device clock of line 0
    bool encoder = true;                ///< one encoder whose count is the line number
    bool remission = false;             ///< RSSI1, computed from the range, because simulated scans have no intensities
};

/// All lines. Lines that are completely Lost are left out, and the counters show this. Ranges are whole counts; NoReturn is 0, DeviceStatus
/// its code. Error: the scanner cannot have such a fan of beams.
[[nodiscard]] Result<std::vector<ScanTelegram>> telegramsOf(const Scan& scan, const TelegramStyle& style = {});

} // namespace edgescan::scanner
