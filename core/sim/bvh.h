// A tree of boxes over a scene's parts: finds the few parts that a beam can hit.
#pragma once

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

    /// The same for a ray from `start`, and boxes that are larger by `margin` on each side. Distances are multiples of `direction`.
    template <class Visit, class Limit>
    void along(const Eigen::Vector3f& start, const Eigen::Vector3f& direction, float margin, Visit visit, Limit limit) const;

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

template <class Visit, class Limit>
void BoxTree::along(const Eigen::Vector3f& start, const Eigen::Vector3f& direction, float margin, Visit visit, Limit limit) const {
    const Eigen::Vector3f inverse = inverseOf(direction);
    const Eigen::Vector3f before = start + Eigen::Vector3f::Constant(margin);
    const Eigen::Vector3f behind = start - Eigen::Vector3f::Constant(margin);
    walk([&](const Node& node) { return entryDistance(node.low - before, node.high - behind, inverse, limit()); }, visit, limit);
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
