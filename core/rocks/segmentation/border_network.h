// A small network that says to which of two segments a cell on their border belongs (docs/method/rocks.md, "Step 6").
#pragma once

#include "core/rocks/segmentation/lanes.h"

#include <array>
#include <cstddef>

namespace edgescan::rocks {

inline constexpr std::size_t kBorderFeatures = 42;
inline constexpr std::size_t kBorderFirst = 48; ///< neurons of the first layer
inline constexpr std::size_t kBorderSecond = 24;

/// The features of kCellsAtOnce questions.
using BorderFeatureLanes = std::array<Lanes<float>, kBorderFeatures>;

/// Weights by input, then by neuron.
struct BorderNetwork {
    std::array<float, kBorderFeatures> middle{}, scale{}; ///< a feature enters as (feature - middle) x scale, within -4..4
    std::array<float, kBorderFeatures * kBorderFirst> first{};
    std::array<float, kBorderFirst> firstBias{};
    std::array<float, kBorderFirst * kBorderSecond> second{};
    std::array<float, kBorderSecond> secondBias{};
    std::array<float, kBorderSecond> third{};
    float thirdBias = 0;

    /// The log odds of "belongs to the other segment", by lane. The same bits with every instruction set.
    [[nodiscard]] Lanes<float> says(const BorderFeatureLanes& features) const;
};

/// The network that `edgescan-lab learn-borders` made (border_weights.inc).
[[nodiscard]] const BorderNetwork& learnedBorders();

} // namespace edgescan::rocks
