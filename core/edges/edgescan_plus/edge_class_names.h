// Names of the classes of edges.
#pragma once

#include "core/edges/settings/settings.h"

namespace edgescan::edges {

/// "jump", "convex", "concave", "border", "silhouette", "rim"; "none".
[[nodiscard]] const char* edgeClassName(DepthEdge kind);
/// The name for people, as on the switches: "data border", "outline before a void", "void rim".
[[nodiscard]] const char* edgeClassLabel(DepthEdge kind);
/// Of any cell: "no edge", "edge" where the method has no classes, otherwise edgeClassLabel() or edgeClassName().
[[nodiscard]] const char* edgeLabel(bool edge, DepthEdge kind);
[[nodiscard]] const char* edgeName(bool edge, DepthEdge kind);

} // namespace edgescan::edges
