// Names of the classes of edges.
#include "core/edges/edgescan_plus/edge_class_names.h"

#include "core/edges/settings/parameters.h"

namespace edgescan::edges {

const char* edgeClassName(DepthEdge kind) {
    static constexpr const char* kNames[]{"none", "jump", "convex", "concave", "border", "silhouette", "rim"};
    return kNames[static_cast<std::size_t>(kind)];
}

const char* edgeClassLabel(DepthEdge kind) {
    return kind == DepthEdge::None ? "none" : findParameter("classes")->choices[static_cast<std::size_t>(kind) - 1].label;
}

const char* edgeLabel(bool edge, DepthEdge kind) { return !edge ? "no edge" : kind == DepthEdge::None ? "edge" : edgeClassLabel(kind); }

const char* edgeName(bool edge, DepthEdge kind) { return edge && kind != DepthEdge::None ? edgeClassName(kind) : edgeLabel(edge, kind); }

} // namespace edgescan::edges
