// Converts the operator's settings to those of EdgeScan+.
#pragma once

#include "core/edges/edgescan_plus/edgescan_plus.h"
#include "core/edges/settings/settings.h"

namespace edgescan::edges {

/// The settings of EdgeScan+. The method must not be Canny. Outlines and Jumps are EdgeScan+ with fewer classes.
[[nodiscard]] DepthEdgeSettings depthEdgeSettings(const Settings& settings);

/// "jump", "convex", "concave", "border", "silhouette"; "none".
[[nodiscard]] const char* edgeClassName(DepthEdge kind);
/// The name for people, as on the switches: "data border", "outline before a void".
[[nodiscard]] const char* edgeClassLabel(DepthEdge kind);

} // namespace edgescan::edges
