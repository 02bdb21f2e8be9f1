// What rocks are made from: the surface, its cracks and its thinned edges (docs/rocks-method.md, "Inputs").
#pragma once

#include "core/edges/edgescan_plus/edgescan_plus.h"
#include "core/edges/pipeline/detection.h"

#include <memory>

namespace edgescan {

/// All grids are lines x beams of one scan. Made once, never changed.
struct RockInputs {
    std::shared_ptr<const Scan> scan;
    std::shared_ptr<const DepthSurface> surface;     ///< cleaned inverse range and its noise
    std::shared_ptr<const DepthResponses> responses; ///< thinned jumps and creases
    std::shared_ptr<const DepthCracks> cracks;       ///< before suppression
};

/// Takes what the detection holds and works out the rest. A method that does not measure the surface gives the rocks of EdgeScan+ with the
/// same settings.
[[nodiscard]] RockInputs rockInputs(const Detection& detection);

} // namespace edgescan
