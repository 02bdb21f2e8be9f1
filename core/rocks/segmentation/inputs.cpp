// Collects the inputs of rock detection.
#include "core/rocks/segmentation/inputs.h"

#include "core/edges/edgescan_plus/edgescan_plus.h"
#include "core/edges/settings/method_traits.h"

namespace edgescan::rocks {

Inputs rockInputs(const edges::Detection& detection) {
    Inputs inputs{detection.scan, detection.surface, detection.responses, detection.cracks};
    edges::Settings settings = detection.settings;
    if (!edges::reads(settings.method, edges::kReadsSurface)) settings.method = edges::Method::EdgeScanPlus;
    if (!inputs.surface) inputs.surface = std::make_shared<const edges::DepthSurface>(edges::depthSurface(*inputs.scan, settings));
    if (inputs.responses && inputs.cracks) return inputs;
    auto cracks = std::make_shared<edges::DepthCracks>();
    inputs.responses = std::make_shared<const edges::DepthResponses>(edges::depthResponses(*inputs.surface, settings, cracks.get()));
    inputs.cracks = std::move(cracks);
    return inputs;
}

} // namespace edgescan::rocks
