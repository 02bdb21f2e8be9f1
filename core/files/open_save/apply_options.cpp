// Angles, place and straightening.
#include "core/files/open_save/apply_options.h"

#include "core/scan/angle_correction/straighten_scan.h"
#include "core/scan/georef/place_scan.h"
#include "core/scan/grid/given_angles.h"

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
