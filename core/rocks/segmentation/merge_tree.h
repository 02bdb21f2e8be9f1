// The order in which segments are merged to rocks (docs/method/rocks.md, "Step 5").
#pragma once

#include "core/rocks/segmentation/merge_price.h"
#include "core/rocks/segmentation/segments.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace edgescan::rocks {

/// Two groups of segments become one. A group has the number of its smallest segment.
struct Merge {
    double height = 0.0;         ///< they are merged from this level on: the largest price of this merge and all before it
    std::uint32_t remaining = 0; ///< number of the merged group; smaller than `gone`
    std::uint32_t gone = 0;      ///< number of the group that disappears
};

/// Ascending by height.
struct MergeTree {
    std::vector<Merge> merges;
    std::shared_ptr<const std::vector<Merge>> plain{}; ///< before any pairs; null: these are without pairs
};

/// A person's decision about two segments. Of two contradicting decisions the later one is valid.
struct SegmentPair {
    std::uint32_t a = 0, b = 0; ///< b = 0, not joined: `a`, with what other pairs join to it, is separate from all other segments
    bool joined = false;        ///< true: one rock; false: separate at every level
};

/// Repeatedly merges the two groups with the lowest price and takes the prices of all their neighbours again; ties are broken by smaller
/// segment numbers.
[[nodiscard]] MergeTree mergeTree(const Segmentation& segments);
/// The same with the mean z of the border as the price.
[[nodiscard]] MergeTree mergeTree(std::uint32_t segments, std::span<const SegmentBorder> borders);

/// `tree` with these pairs in place of those that it has. Joined pairs come first, at minus infinity. Then each merge of the tree without
/// pairs joins, at its height, what the pairs left of its two groups, where that is not kept apart: nothing else changes. `segments` may be
/// cut finer than those of the tree.
[[nodiscard]] MergeTree withPairs(const MergeTree& tree, const Segmentation& segments, std::span<const SegmentPair> pairs);

/// For a lesson: the price, and what happens.
struct MergeRules {
    /// Log odds that the groups `a` and `b` are two rocks.
    std::function<double(const PairFeatures&, std::uint32_t a, std::uint32_t b)> price;
    std::function<void(const Merge&)> merged{}; ///< may be empty
};
/// The same with other prices.
[[nodiscard]] MergeTree mergeTree(const Segmentation& segments, const MergeRules& rules);

/// The number of the group of each segment after all merges up to `level`, by segment; kOpen for kOpen.
[[nodiscard]] std::vector<std::uint32_t> groupsAt(const MergeTree& tree, std::uint32_t segments, double level);

} // namespace edgescan::rocks
