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

/// Boxes in a binary tree, for rays that start at the origin.
class BoxTree {
public:
    BoxTree() = default;
    explicit BoxTree(const std::vector<Eigen::AlignedBox3f>& boxes);

    /// Calls visit(part) for every part whose box the ray enters before `limit()`, approximately from near to far.
    template <class Visit, class Limit>
    void along(const Eigen::Vector3f& direction, Visit visit, Limit limit) const;

private:
    struct Node {
        Eigen::Vector3f low = Eigen::Vector3f::Zero();
        Eigen::Vector3f high = Eigen::Vector3f::Zero();
        std::int32_t first = 0; ///< end node: first entry of order_; inner node: the left child, whose sibling follows it
        std::int32_t count = 0; ///< number of entries of an end node, 0 for an inner node
    };
    void split(std::size_t node, const std::vector<Eigen::AlignedBox3f>& boxes);

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

template <class Visit, class Limit>
void BoxTree::along(const Eigen::Vector3f& direction, Visit visit, Limit limit) const {
    if (nodes_.empty()) return;
    Eigen::Vector3f inverse;
    for (int axis = 0; axis < 3; ++axis) inverse[axis] = 1.0F / (std::abs(direction[axis]) < 1e-12F ? 1e-12F : direction[axis]);
    struct Pending {
        std::int32_t node;
        float enter;
    };
    std::array<Pending, 64> stack; // deeper than any balanced tree of 2^31 parts
    std::size_t depth = 0;
    stack[depth++] = {0, entryDistance(nodes_[0].low, nodes_[0].high, inverse, limit())};
    while (depth > 0) {
        const Pending top = stack[--depth];
        if (!(top.enter <= limit()) || top.enter == std::numeric_limits<float>::infinity()) continue;
        const Node& node = nodes_[static_cast<std::size_t>(top.node)];
        if (node.count > 0) {
            for (std::int32_t i = 0; i < node.count; ++i) visit(order_[static_cast<std::size_t>(node.first + i)]);
            continue;
        }
        const Node& left = nodes_[static_cast<std::size_t>(node.first)];
        const Node& right = nodes_[static_cast<std::size_t>(node.first + 1)];
        Pending near{node.first, entryDistance(left.low, left.high, inverse, limit())};
        Pending far{node.first + 1, entryDistance(right.low, right.high, inverse, limit())};
        if (far.enter < near.enter) std::swap(near, far);
        stack[depth++] = far;
        stack[depth++] = near;
    }
}

} // namespace edgescan::sim
