// Collects the inputs of rock detection.
#include "core/rocks/segmentation/inputs.h"

#include "core/edges/edgescan_plus/edgescan_plus.h"
#include "core/edges/settings/method_traits.h"
#include "core/rocks/segmentation/least_noise.h"

#include <cmath>

namespace edgescan::rocks {
namespace {

constexpr double kMargin = 1.1; // the least of several bins is a little too low
constexpr int kRules = 4;       // of default set 4: the tree of merges and the confidence were fitted by them

// Noise at 5 m for rocks, mm: NaN where that of the detection is used. The operator's noise is used as it is, and so is noise with memory.
double noiseForRocks(const edges::DepthSurface& surface, const edges::Settings& settings) {
    if (!std::isnan(settings.noiseMm) || surface.memory.windowMm > 0) return settings.noiseMm;
    const double least = kMargin * leastNoiseMm(surface.inverse);
    edges::Settings lower = settings;
    lower.noiseMm = least;
    const double rangeM = surface.scales.rangeM;
    const bool isLower = least > 0 && edges::depthLimits(surface, lower).noise.at(rangeM) < surface.ofRange.at(rangeM);
    return isLower ? least : settings.noiseMm;
}

} // namespace

Inputs rockInputs(const edges::Detection& detection) {
    Inputs inputs{detection.scan, detection.surface, detection.responses, detection.cracks};
    edges::Settings settings = detection.settings;
    if (!edges::reads(settings.method, edges::kReadsSurface)) settings.method = edges::Method::EdgeScanPlus;
    if (!inputs.surface) inputs.surface = std::make_shared<const edges::DepthSurface>(edges::depthSurface(*inputs.scan, settings));
    const double noiseMm = noiseForRocks(*inputs.surface, settings);
    const bool same = settings.rules == kRules && (std::isnan(noiseMm) || noiseMm == settings.noiseMm);
    settings.rules = kRules;
    if (same && inputs.responses && inputs.cracks) return inputs;
    settings.noiseMm = noiseMm;
    auto cracks = std::make_shared<edges::DepthCracks>();
    inputs.responses = std::make_shared<const edges::DepthResponses>(edges::depthResponses(*inputs.surface, settings, cracks.get()));
    inputs.cracks = std::move(cracks);
    return inputs;
}

} // namespace edgescan::rocks
