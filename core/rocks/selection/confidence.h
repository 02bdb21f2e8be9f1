// The confidence of regions: how probably an outline is right (docs/method/rocks.md, "Confidence").
#pragma once

#include "core/base/boosted_trees.h"
#include "core/rocks/selection/rock_map.h"

#include <array>
#include <span>
#include <vector>

namespace edgescan::rocks {

/// What is known about one region: its near share; R within -6 .. 12; the log odds of what the rocks of the scan have on average by their
/// own E and R; the mean R of its neighbours; levels below and above; E; bulge, edge share, depth ratio, box share; the sides of the sweep
/// that it reaches; its solid angle, sr. The grid and the unit do not matter.
inline constexpr int kConfidenceInputs = 13;
using ConfidenceInputs = std::array<float, kConfidenceInputs>;

/// By region of `map`, of which borders and scores are known.
[[nodiscard]] std::vector<ConfidenceInputs> confidenceInputs(const RegionMap& map);

/// The trees that `edgescan-lab learn-confidence` made (confidence_trees.inc).
struct ConfidenceModel {
    std::int32_t start;
    std::span<const BoostedTree> trees;
};
[[nodiscard]] ConfidenceModel confidenceModel();

/// 0..1
[[nodiscard]] double confidenceOf(const ConfidenceInputs& inputs, const ConfidenceModel& model);

} // namespace edgescan::rocks
