// The price of a merge: what the border of two bodies and their shapes say about whether they are two rocks (docs/method/rocks.md,
// "Step 5").
#pragma once

#include "core/rocks/segmentation/bodies.h"

#include <array>
#include <vector>

namespace edgescan::rocks {

/// The border of two bodies.
struct BodyBorder {
    SegmentBorder sums;
    OutlineSums outline;
};

/// A body and its outline.
struct Body {
    /// The part of the outline at one neighbour.
    struct Side {
        double z = 0.0;          ///< mean log odds of "two rocks" per crack
        std::int64_t length = 0; ///< in units of kLengthStep
    };
    BodySums sums;
    BodyShape shape;
    std::vector<Side> sides;
};

inline constexpr int kPairFeatures = 51;
/// Of the border: means of z, e1, e2, v, w; its length; the share of each body that is nearer; the share of valleys; the means of
/// OutlineSums. Of the lesser body, the larger one (by measured cells) and of both together: sizes and shapes. Of the pair: what the union
/// gains, the rest of both outlines, the range, and how the surfaces lie to each other. The grid of the scan does not matter.
using PairFeatures = std::array<float, kPairFeatures>;

/// `border.sums.a` belongs to `a`, `border.sums.b` to `b`.
[[nodiscard]] PairFeatures pairFeatures(const Body& a, const Body& b, const BodyBorder& border, const RangeNoise& noise);

/// Log odds that two bodies are two rocks, by the trees that `edgescan-lab learn-rocks` made (merge_trees.inc).
[[nodiscard]] double mergePrice(const PairFeatures& features);

} // namespace edgescan::rocks
