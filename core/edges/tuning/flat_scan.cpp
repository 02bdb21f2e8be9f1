// Flat: the share of cells that fold. Quiet: the noise that the scan was measured to have.
#include "core/edges/tuning/flat_scan.h"

#include "core/edges/edgescan_plus/edgescan_plus.h"
#include "core/edges/settings/method_traits.h"

namespace edgescan::edges {
namespace {

constexpr double kFlatShare = 0.03; // of the cells fold
constexpr double kQuietMm = 8.0;    // sigma at 5 m; 6.75 mm for an LMS511

} // namespace

bool isFlatAndQuiet(const Detection& detection) {
    if (!detection.responses || !reads(detection.settings.method, kReadsCreases) || !detection.settings.roughScans) return false;
    const DepthResponses& found = *detection.responses;
    return !found.neighboursAlike && found.noise.at(5.0) > 0 && found.noise.at(5.0) <= kQuietMm && found.roughness.share <= kFlatShare;
}

} // namespace edgescan::edges
