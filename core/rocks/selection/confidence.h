// The confidence of regions: how probably an outline is right (docs/method/rocks.md, "Confidence").
#pragma once

#include "core/rocks/selection/rock_map.h"

#include <array>
#include <cstddef>
#include <vector>

namespace edgescan::rocks {

/// What is known about one region: the share of its outline where it is the nearer side of a jump; R within -6 .. 12; the log odds of what
/// the rocks of the scan have on average by their own E and R; the mean R of its neighbours.
inline constexpr std::size_t kConfidenceInputs = 4;
using ConfidenceInputs = std::array<double, kConfidenceInputs>;

/// By region of `map`, of which borders and scores are known.
[[nodiscard]] std::vector<ConfidenceInputs> confidenceInputs(const RegionMap& map);

/// The constant, then one factor per input.
using ConfidenceWeights = std::array<double, 1 + kConfidenceInputs>;
/// The weights that `edgescan-lab learn-confidence` made (confidence_weights.inc).
[[nodiscard]] const ConfidenceWeights& confidenceWeights();

/// 0..1
[[nodiscard]] double confidenceOf(const ConfidenceInputs& inputs, const ConfidenceWeights& weights);

} // namespace edgescan::rocks
