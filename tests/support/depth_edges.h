// EdgeScan+ from a scan to its edges in one call; the program stores the intermediate results.
#pragma once

#include "core/edges/edgescan_plus/edgescan_plus.h"

namespace edgescan::test {

inline edges::DepthResponses depthResponses(const Scan& scan, const edges::Settings& settings) {
    return edgescan::edges::depthResponses(edges::depthSurface(scan, settings), settings);
}

inline edges::DepthEdges depthEdges(const Scan& scan, const edges::Settings& settings) {
    return edges::decideDepthEdges(depthResponses(scan, settings), settings);
}

} // namespace edgescan::test
