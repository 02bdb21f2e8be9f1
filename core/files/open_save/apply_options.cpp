// Angles, place and straightening.
#include "core/files/open_save/apply_options.h"

#include "core/files/formats/formats.h"
#include "core/scan/angle_correction/straighten_scan.h"
#include "core/scan/georef/place_scan.h"
#include "core/scan/grid/given_angles.h"

#include <algorithm>
#include <iterator>

namespace edgescan::files {

Result<Done> applyOptions(Scan& scan, const Source& source, bool placesItself) {
    const ReadingOptions& options = *source.options;
    applyGivenAngles(scan, options);
    if (placesItself || (options.pose.empty() && options.calibration.empty())) return Done{};
    if (options.pose.empty()) return source.refused("a calibration alone gives no place", "give --pose POSE.json too");
    auto placement = openPlacement(options.pose, options.calibration, scan);
    if (!placement) return placement.error();
    scan.placement = *placement;
    return Done{};
}

Result<Done> checkOptions(Scan& scan, const ReadingOptions& options, const Format& format) {
    std::vector<std::string_view> others;
    for (const Format& other : formats()) std::ranges::copy(other.options, std::back_inserter(others));
    std::erase_if(others,
                  [&](std::string_view key) { return key == "scan" || std::ranges::find(format.options, key) != format.options.end(); });
    std::ranges::copy(idleOptions(options, others, "the format " + scan.format + " does not have it"), std::back_inserter(scan.warnings));
    const bool hasOne = std::ranges::find(format.options, "scan") == format.options.end();
    if (!hasOne || options.scanIndex.value_or(0) == 0) return Done{};
    return Error{"the file holds one scan", "--scan " + std::to_string(*options.scanIndex), "use --scan 0"};
}

Scan straightenedAsAsked(Scan scan, const ReadingOptions& options) {
    if (!options.straighten) {
        if (auto warning = displacementWarning(scan)) scan.warnings.push_back(std::move(*warning));
        return scan;
    }
    Scan straight = straightened(std::move(scan));
    straight.openedWith = readingOptionsText(options);
    return straight;
}

} // namespace edgescan::files
