// Collects the inputs of rock detection.
#include "core/rocks/segmentation/inputs.h"

#include "core/edges/edgescan_plus/plus_settings.h"
#include "core/edges/settings/method_traits.h"

namespace edgescan {

RockInputs rockInputs(const Detection& detection) {
    RockInputs inputs{detection.scan, detection.surface, detection.responses, detection.cracks};
    if (inputs.surface && inputs.responses && inputs.cracks) return inputs;
    Settings settings = detection.settings;
    if (!reads(settings.method, kReadsSurface)) settings.method = Method::EdgeScanPlus;
    const DepthEdgeSettings depth = depthEdgeSettings(settings);
    if (!inputs.surface)
        inputs.surface = std::make_shared<const DepthSurface>(depthSurface(*inputs.scan, depth.straighten, 0, depth.noiseKind));
    auto cracks = std::make_shared<DepthCracks>();
    inputs.responses = std::make_shared<const DepthResponses>(depthResponses(*inputs.surface, depth, cracks.get()));
    inputs.cracks = std::move(cracks);
    return inputs;
}

} // namespace edgescan
