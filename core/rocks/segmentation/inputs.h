// The inputs of rock detection: the surface, its cracks and its edges after suppression (docs/method/rocks.md, "Inputs").
#pragma once

#include "core/edges/pipeline/detection.h"

#include <memory>

namespace edgescan::rocks {

/// All grids are lines x beams of one scan. Immutable after construction.
struct Inputs {
    std::shared_ptr<const Scan> scan;
    std::shared_ptr<const edges::DepthSurface> surface;     ///< cleaned inverse range and its noise
    std::shared_ptr<const edges::DepthResponses> responses; ///< jumps and creases after suppression
    std::shared_ptr<const edges::DepthCracks> cracks;       ///< jumps and creases before suppression
};

/// Takes the results of the detection and computes the missing ones. For a method that does not measure the surface: the rocks of EdgeScan+
/// with the same settings.
[[nodiscard]] Inputs rockInputs(const edges::Detection& detection);

} // namespace edgescan::rocks
