// When a scan was measured.
#include "core/scan/grid/scan_time.h"

#include "core/base/utc_time.h"
#include "core/scan/grid/acquisition.h"
#include "core/scan/grid/placement.h"

namespace edgescan {

std::optional<double> startOfScan(const Scan& scan) {
    std::optional<double> start;
    if (scan.acquisition && !scan.acquisition->lineTimesS.empty())
        start = scan.acquisition->lineTimesS.front();
    else if (scan.acquisition)
        start = parseUtc(scan.acquisition->startUtc);
    if (!start && scan.placement) start = parseUtc(scan.placement->scanStartUtc);
    if (!start && scan.placement) start = parseUtc(scan.placement->timeUtc);
    const bool isHeld = start && *start > 0 && *start < static_cast<double>(kLatestNs) * 1e-9;
    return isHeld ? start : std::nullopt;
}

} // namespace edgescan
