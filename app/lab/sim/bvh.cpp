// Builds the tree: halves the parts along the longest side of the box of their centres.
#include "app/lab/sim/bvh.h"

#include <numeric>

namespace edgescan::sim {
BoxTree::BoxTree(const std::vector<Eigen::AlignedBox3f>& boxes, std::int32_t endNodeSize) : order_(boxes.size()) {
    if (boxes.empty()) return;
    std::iota(order_.begin(), order_.end(), 0);
    nodes_.reserve(2 * boxes.size());
    nodes_.push_back({.first = 0, .count = static_cast<std::int32_t>(boxes.size())});
    split(0, boxes, endNodeSize);
    nodes_.shrink_to_fit();
}

void BoxTree::split(std::size_t node, const std::vector<Eigen::AlignedBox3f>& boxes, std::int32_t endNodeSize) {
    const std::int32_t first = nodes_[node].first;
    const std::int32_t count = nodes_[node].count;
    Eigen::AlignedBox3f all;
    Eigen::AlignedBox3f centres;
    for (std::int32_t i = first; i < first + count; ++i) {
        const auto& box = boxes[static_cast<std::size_t>(order_[static_cast<std::size_t>(i)])];
        all.extend(box);
        centres.extend(box.center());
    }
    nodes_[node].low = all.min();
    nodes_[node].high = all.max();
    if (count <= endNodeSize) return;
    int axis = 0;
    centres.sizes().maxCoeff(&axis);
    const auto middle = order_.begin() + first + count / 2;
    std::nth_element(order_.begin() + first, middle, order_.begin() + first + count, [&](std::int32_t a, std::int32_t b) {
        const float ca = boxes[static_cast<std::size_t>(a)].center()[axis];
        const float cb = boxes[static_cast<std::size_t>(b)].center()[axis];
        return ca != cb ? ca < cb : a < b; // a total order, so that every standard library gives the same tree
    });
    const auto child = static_cast<std::int32_t>(nodes_.size());
    nodes_.push_back({.first = first, .count = count / 2});
    nodes_.push_back({.first = first + count / 2, .count = count - count / 2});
    nodes_[node].first = child;
    nodes_[node].count = 0;
    split(static_cast<std::size_t>(child), boxes, endNodeSize);
    split(static_cast<std::size_t>(child) + 1, boxes, endNodeSize);
}

} // namespace edgescan::sim
