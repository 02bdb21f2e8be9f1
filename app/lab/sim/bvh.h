// A tree of boxes over a scene's parts: finds the few parts that a beam can hit.
#pragma once

#include "app/lab/sim/rays.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

#include <cstdint>
#include <vector>

namespace edgescan::sim {

/// Boxes in a binary tree, for rays.
class BoxTree {
public:
    BoxTree() = default;
    /// @param endNodeSize most parts of an end node
    explicit BoxTree(const std::vector<Eigen::AlignedBox3f>& boxes, std::int32_t endNodeSize = 2);

    /// Calls visit(part) for every part whose box a ray from the origin enters before `limit()`, approximately from near to far.
    template <class Visit, class Limit>
    void along(const Eigen::Vector3f& direction, Visit visit, Limit limit) const;

    /// The same for a bundle: for every part whose box, larger by `margin` on each side, one of its rays enters before that ray's hit.
    /// visit(part) may shorten the hits.
    template <class Visit>
    void along(const RayBundle& bundle, float margin, const BundleHits& hits, Visit visit) const;

private:
    struct Node {
        Eigen::Vector3f low = Eigen::Vector3f::Zero();
        Eigen::Vector3f high = Eigen::Vector3f::Zero();
        std::int32_t first = 0; ///< end node: first entry of order_; inner node: the left child, whose sibling follows it
        std::int32_t count = 0; ///< number of entries of an end node, 0 for an inner node
    };
    void split(std::size_t node, const std::vector<Eigen::AlignedBox3f>& boxes, std::int32_t endNodeSize);
    /// entry(node): the distance at which the ray enters its box, infinite if it does not enter before the limit.
    template <class Entry, class Visit, class Limit>
    void walk(Entry entry, Visit visit, Limit limit) const;

    std::vector<Node> nodes_;
    std::vector<std::int32_t> order_;
};

/// Distance at which a ray from the origin enters the box (0 inside); a value above `limit` if it does not enter before that.
inline float entryDistance(const Eigen::Vector3f& low, const Eigen::Vector3f& high, const Eigen::Vector3f& inverse, float limit) {
    float enter = 0.0F;
    float leave = limit;
    for (int axis = 0; axis < 3; ++axis) {
        const float a = low[axis] * inverse[axis];
        const float b = high[axis] * inverse[axis];
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
    }
    return enter <= leave ? enter : std::numeric_limits<float>::infinity();
}

/// The same for a bundle: the smallest of its rays' distances, each with its hit as the limit. @param inverse origins, and directions as
/// their inverse
inline float entryDistance(const Eigen::Array3f& low, const Eigen::Array3f& high, const RayBundle& inverse, const BundleHits& hits) {
    alignas(16) Lanes<float> entry;
    const auto lesser = [](float a, float b) { return a < b ? a : b; };
    const auto larger = [](float a, float b) { return a > b ? a : b; };
    for (std::size_t i = 0; i < kLanes; ++i) {
        const float ax = (low[0] - inverse.ox[i]) * inverse.dx[i], bx = (high[0] - inverse.ox[i]) * inverse.dx[i];
        const float ay = (low[1] - inverse.oy[i]) * inverse.dy[i], by = (high[1] - inverse.oy[i]) * inverse.dy[i];
        const float az = (low[2] - inverse.oz[i]) * inverse.dz[i], bz = (high[2] - inverse.oz[i]) * inverse.dz[i];
        const float enter = larger(larger(lesser(ax, bx), lesser(ay, by)), larger(lesser(az, bz), 0.0F));
        const float leave = lesser(lesser(larger(ax, bx), larger(ay, by)), lesser(larger(az, bz), hits.distanceM[i]));
        entry[i] = enter <= leave ? enter : std::numeric_limits<float>::infinity();
    }
    for (std::size_t half = kLanes / 2; half > 3; half /= 2) {
        for (std::size_t i = 0; i < half; ++i) entry[i] = lesser(entry[i], entry[i + half]);
    }
    return lesser(lesser(entry[0], entry[1]), lesser(entry[2], lesser(entry[3], lesser(entry[4], entry[5]))));
}

inline Eigen::Vector3f inverseOf(const Eigen::Vector3f& direction) {
    Eigen::Vector3f inverse;
    for (int axis = 0; axis < 3; ++axis) inverse[axis] = 1.0F / (std::abs(direction[axis]) < 1e-12F ? 1e-12F : direction[axis]);
    return inverse;
}

template <class Visit, class Limit>
void BoxTree::along(const Eigen::Vector3f& direction, Visit visit, Limit limit) const {
    const Eigen::Vector3f inverse = inverseOf(direction);
    walk([&](const Node& node) { return entryDistance(node.low, node.high, inverse, limit()); }, visit, limit);
}

template <class Visit>
void BoxTree::along(const RayBundle& bundle, float margin, const BundleHits& hits, Visit visit) const {
    RayBundle inverse = bundle; // only its directions count
    for (Lanes<float>* lanes : {&inverse.dx, &inverse.dy, &inverse.dz}) {
        for (float& d : *lanes) d = 1.0F / (std::abs(d) < 1e-12F ? 1e-12F : d);
    }
    float limit = farthest(hits);
    const auto visitPart = [&](std::int32_t part) {
        visit(part);
        limit = farthest(hits);
    };
    walk([&](const Node& node) { return entryDistance(node.low.array() - margin, node.high.array() + margin, inverse, hits); }, visitPart,
         [&] { return limit; });
}

template <class Entry, class Visit, class Limit>
void BoxTree::walk(Entry entry, Visit visit, Limit limit) const {
    if (nodes_.empty()) return;
    struct Pending {
        std::int32_t node;
        float enter;
    };
    std::array<Pending, 64> stack; // deeper than any balanced tree of 2^31 parts
    std::size_t depth = 0;
    stack[depth++] = {0, entry(nodes_[0])};
    while (depth > 0) {
        const Pending top = stack[--depth];
        if (!(top.enter <= limit()) || top.enter == std::numeric_limits<float>::infinity()) continue;
        const Node& node = nodes_[static_cast<std::size_t>(top.node)];
        if (node.count > 0) {
            for (std::int32_t i = 0; i < node.count; ++i) visit(order_[static_cast<std::size_t>(node.first + i)]);
            continue;
        }
        Pending near{node.first, entry(nodes_[static_cast<std::size_t>(node.first)])};
        Pending far{node.first + 1, entry(nodes_[static_cast<std::size_t>(node.first + 1)])};
        if (far.enter < near.enter) std::swap(near, far);
        stack[depth++] = far;
        stack[depth++] = near;
    }
}

} // namespace edgescan::sim
