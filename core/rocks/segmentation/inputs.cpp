// Collects the inputs of rock detection.
#include "core/rocks/segmentation/inputs.h"

#include "core/edges/settings/method_traits.h"

namespace edgescan {

RockInputs rockInputs(const Detection& detection) {
    RockInputs inputs{detection.scan, detection.surface, detection.responses, detection.cracks};
    if (inputs.surface && inputs.responses && inputs.cracks) return inputs;
    Settings settings = detection.settings;
    if (!reads(settings.method, kReadsSurface)) settings.method = Method::EdgeScanPlus;
    if (!inputs.surface)
        inputs.surface = std::make_shared<const DepthSurface>(depthSurface(*inputs.scan, settings.straighten, 0, settings.noiseKind));
    auto cracks = std::make_shared<DepthCracks>();
    inputs.responses = std::make_shared<const DepthResponses>(depthResponses(*inputs.surface, settings, cracks.get()));
    inputs.cracks = std::move(cracks);
    return inputs;
}

} // namespace edgescan
