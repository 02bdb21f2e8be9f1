// The order in which segments are merged to rocks (docs/method/rocks.md, "Step 5").
#pragma once

#include "core/rocks/segmentation/segments.h"

#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace edgescan::rocks {

/// Two groups of segments become one. A group has the number of its smallest segment.
struct Merge {
    double height = 0.0;         ///< they are merged from this level on: the largest mean log odds of this merge and all before it
    std::uint32_t remaining = 0; ///< number of the merged group; smaller than `gone`
    std::uint32_t gone = 0;      ///< number of the group that disappears
};

/// Ascending by height.
struct MergeTree {
    std::vector<Merge> merges;
};

/// A person's decision about two segments. Of two contradicting decisions the later one is valid.
struct SegmentPair {
    std::uint32_t a = 0, b = 0; ///< b = 0, not joined: `a`, with what other pairs join to it, is separate from all other segments
    bool joined = false;        ///< true: one rock; false: separate at every level
};

/// Repeatedly merges at the border with the lowest mean log odds; ties are broken by smaller segment numbers. Joined pairs come first, at
/// minus infinity.
[[nodiscard]] MergeTree mergeTree(std::uint32_t segments, std::span<const SegmentBorder> borders, std::span<const SegmentPair> pairs = {});

/// The number of the group of each segment after all merges up to `level`, by segment; kOpen for kOpen.
[[nodiscard]] std::vector<std::uint32_t> groupsAt(const MergeTree& tree, std::uint32_t segments, double level);

} // namespace edgescan::rocks
