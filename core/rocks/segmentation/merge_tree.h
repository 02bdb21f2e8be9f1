// In which order leaves become rocks (docs/rocks-method.md, "Step 5").
#pragma once

#include "core/rocks/segmentation/segments.h"

#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace edgescan {

/// Two groups of leaves become one. A group has the name of its smallest leaf.
struct Merge {
    double height = 0.0;    ///< level from which on they are one: the largest mean log odds of this merge and all before it
    std::uint32_t kept = 0; ///< name of the group afterwards; smaller than `gone`
    std::uint32_t gone = 0;
};

/// Ascending by height.
struct MergeTree {
    std::vector<Merge> merges;
};

/// What a person decided of leaves; the later one of two that contradict each other holds.
struct LeafPair {
    std::uint32_t a = 0, b = 0;
    bool joined = false; ///< else apart at every level
};

/// Merges the border of least mean log odds again and again, ties by smaller leaves. Pairs that are joined come first, at minus infinity.
[[nodiscard]] MergeTree mergeTree(std::uint32_t leaves, std::span<const LeafBorder> borders, std::span<const LeafPair> pairs = {});

/// The name of the group of each leaf, by leaf, after all merges up to `level`; kOpen for kOpen.
[[nodiscard]] std::vector<std::uint32_t> groupsAt(const MergeTree& tree, std::uint32_t leaves, double level);

} // namespace edgescan
