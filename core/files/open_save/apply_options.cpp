// Angles, place and straightening.
#include "core/files/open_save/apply_options.h"
#include "core/base/translated_text.h"

#include "core/base/number_text.h"
#include "core/base/physical_limits.h"
#include "core/files/formats/formats.h"
#include "core/scan/angle_correction/straighten_scan.h"
#include "core/scan/georef/place_scan.h"
#include "core/scan/grid/given_angles.h"

#include <algorithm>
#include <iterator>

namespace edgescan::files {

namespace {

/// Angles that the operator gave and that no scan has: the flag is at fault, not the file.
std::optional<Error> beyondLimits(const std::vector<double>& degrees, const char* of, const std::optional<double>& start,
                                  const std::optional<double>& step, const PhysicalLimit& limit) {
    const auto off = std::ranges::find_if(degrees, [&](double angle) { return !limit.hold(angle); });
    if (off == degrees.end() || (!start && !step)) return std::nullopt;
    return Error{
        withValues(*of == 'b' ? "beam %1 of %2 would be at %3 degrees" : "line %1 of %2 would be at %3 degrees",
                   {off - degrees.begin(), degrees.size(), significantText(*off, 6)}),
        std::string("--") + of + (step ? "-step " : "-start ") + shortestText(step ? *step : *start),
        withValues("give angles from %1 to %2 degrees", {significantText(limit.limits.least, 6), significantText(limit.limits.most, 6)})};
}

} // namespace

Result<Done> applyOptions(Scan& scan, const Source& source, bool placesItself) {
    const ReadingOptions& options = *source.options;
    applyGivenAngles(scan, options);
    if (const auto* polar = std::get_if<PolarGeometry>(&scan.geometry)) {
        if (auto bad = beyondLimits(polar->beamDeg, "beam", options.beamStartDeg, options.beamStepDeg, physical::kBeamDeg)) return *bad;
        if (auto bad = beyondLimits(polar->lineDeg, "line", options.lineStartDeg, options.lineStepDeg, physical::kLineDeg)) return *bad;
    }
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
    std::ranges::copy(idleOptions(options, others, withValues("the format %1 does not have it", {scan.format})),
                      std::back_inserter(scan.warnings));
    const bool hasOne = std::ranges::find(format.options, "scan") == format.options.end();
    if (!hasOne || options.scanIndex.value_or(0) == 0) return Done{};
    return noSuchScan(*options.scanIndex, 1);
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
