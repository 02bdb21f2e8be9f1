// Fits the confidence of rocks (docs/method/rocks.md, "Confidence").
#pragma once

#include "app/lab/learning/learn_rocks.h"
#include "core/rocks/selection/confidence.h"

namespace edgescan::lab {

/// Adds every region that looks like a rock, with `weight`. Yes: it is a rock to an IoU above one half.
void addConfidenceSamples(const RockLesson& lesson, const rocks::MergeTree& tree, float weight, TreeSamples& samples);

struct LearntConfidence {
    std::array<double, rocks::kConfidenceBase> base{}; ///< rounded to what confidenceText() writes
    LearntTrees trees;
};

/// A regression on the inputs of the base, and trees that add to it. The same samples give the same for any number of threads.
[[nodiscard]] LearntConfidence learntConfidence(TreeSamples samples, BoostingChoices choices, int threads);
[[nodiscard]] AnswerQuality qualityOf(TreeSamples samples, const LearntConfidence& learnt);

/// The text of a file that gives `kBase`, `kStart` and `kTrees`.
[[nodiscard]] std::string confidenceText(const LearntConfidence& learnt, const std::string& madeBy);

} // namespace edgescan::lab
