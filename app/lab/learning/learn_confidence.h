// Fits the confidence of rocks (docs/method/rocks.md, "Confidence").
#pragma once

#include "app/lab/learning/learn_rocks.h"

namespace edgescan::lab {

/// Adds every region that looks like a rock, with `weight`. Yes: it is a rock to an IoU above one half.
void addConfidenceSamples(const RockLesson& lesson, const rocks::MergeTree& tree, float weight, TreeSamples& samples);

} // namespace edgescan::lab
