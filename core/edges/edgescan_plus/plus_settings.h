// What the operator turned, in the terms of EdgeScan+.
#pragma once

#include "core/edges/edgescan_plus/edgescan_plus.h"
#include "core/edges/settings/settings.h"

namespace edgescan {

/// The method must not be Canny. Outlines and jumps are classes of the same edges.
[[nodiscard]] DepthEdgeSettings depthEdgeSettings(const Settings& settings);

/// "jump", "convex", "concave", "border", "silhouette"; "none".
[[nodiscard]] const char* edgeClassName(DepthEdge kind);
/// As people read it, and the switches say it: "data border", "outline before a void".
[[nodiscard]] const char* edgeClassLabel(DepthEdge kind);

} // namespace edgescan
