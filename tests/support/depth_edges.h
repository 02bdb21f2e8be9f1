// EdgeScan+ from a scan to its edges in one call; the program keeps what is in between.
#pragma once

#include "core/edges/edgescan_plus/edgescan_plus.h"

namespace edgescan::test {

inline DepthResponses depthResponses(const Scan& scan, const Settings& settings) {
    return edgescan::depthResponses(depthSurface(scan, settings.straighten, 0, settings.noiseKind), settings);
}

inline DepthEdges depthEdges(const Scan& scan, const Settings& settings) {
    return decideDepthEdges(depthResponses(scan, settings), settings);
}

} // namespace edgescan::test
