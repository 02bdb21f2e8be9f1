// Names of the classes of edges.
#pragma once

#include "core/edges/settings/settings.h"

namespace edgescan::edges {

/// "jump", "convex", "concave", "border", "silhouette", "rim"; "none".
[[nodiscard]] const char* edgeClassName(DepthEdge kind);
/// The name for people, as on the switches: "data border", "outline before a void", "void rim".
[[nodiscard]] const char* edgeClassLabel(DepthEdge kind);

} // namespace edgescan::edges
