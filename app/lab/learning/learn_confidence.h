// Fits the confidence of rocks (docs/method/rocks.md, "Confidence").
#pragma once

#include "app/lab/learning/learn_rocks.h"
#include "core/rocks/selection/confidence.h"

#include <string>
#include <vector>

namespace edgescan::lab {

/// right: the region is a rock to an IoU above one half.
using ConfidenceLesson = LogisticSample<rocks::kConfidenceInputs>;

/// Adds every region that looks like a rock and is either found or false, each with `weight`.
void addConfidenceSamples(const RockLesson& lesson, const rocks::MergeTree& tree, double weight, std::vector<ConfidenceLesson>& samples);

/// Logistic regression. The same samples give the same weights.
[[nodiscard]] rocks::ConfidenceWeights fittedConfidence(const std::vector<ConfidenceLesson>& samples);

/// The text of core/rocks/selection/confidence_weights.inc.
[[nodiscard]] std::string confidenceWeightsText(const rocks::ConfidenceWeights& weights, const std::string& madeBy);

} // namespace edgescan::lab
