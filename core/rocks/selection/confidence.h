// The confidence of regions: how probably an outline is right (docs/method/rocks.md, "Confidence").
#pragma once

#include "core/rocks/selection/rock_map.h"

#include <array>
#include <vector>

namespace edgescan::rocks {

/// What is known about one region: its near share; R within -6 .. 12; the mean R of its neighbours; levels below and above; E; bulge, edge
/// share, depth ratio, box share; the sides of the sweep that it reaches; its solid angle, sr; the log odds of what the rocks of the scan
/// have on average by their own E and R, within 0 and 2. The grid and the unit do not matter.
inline constexpr int kConfidenceInputs = 13;
using ConfidenceInputs = std::array<float, kConfidenceInputs>;

/// The inputs on which log odds depend by one weight each, after a constant: smoothly, whatever scan it is. Trees add what the region is.
inline constexpr std::array<std::size_t, 4> kConfidenceBaseInputs{0, 1, 2, kConfidenceInputs - 1};
inline constexpr std::size_t kConfidenceBase = 1 + kConfidenceBaseInputs.size();
[[nodiscard]] double baseOdds(const std::array<double, kConfidenceBase>& base, const float* inputs);

/// By region of `map`, of which borders and scores are known.
[[nodiscard]] std::vector<ConfidenceInputs> confidenceInputs(const RegionMap& map);

/// 0..1, by the base and the trees that `edgescan-lab learn-confidence` made (confidence_trees.inc).
[[nodiscard]] double confidenceOf(const ConfidenceInputs& inputs);

} // namespace edgescan::rocks
