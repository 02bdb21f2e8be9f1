// Learns boosted trees (core/base/boosted_trees.h) from samples.
#pragma once

#include "core/base/boosted_trees.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace edgescan::lab {

/// What is known of some cells or regions.
struct TreeSamples {
    int features = 0;
    std::vector<float> values;          ///< samples x features
    std::vector<std::uint8_t> yes;      ///< 1 or 0 per sample
    std::vector<float> weight;          ///< per sample
    std::vector<std::int32_t> before{}; ///< per sample, the log odds to which the trees add; empty: one start for all

    [[nodiscard]] std::size_t count() const { return yes.size(); }
    [[nodiscard]] const float* of(std::size_t sample) const { return values.data() + sample * static_cast<std::size_t>(features); }
    void add(std::span<const float> measured, bool answer, float itsWeight);
    void add(const TreeSamples& others);
};

struct BoostingChoices {
    int trees = 40;
    double rate = 0.25;
    double least = 60;  ///< weight of the samples of a leaf
    double ridge = 1.0; ///< added to the curvature of a leaf
    int features = 0;   ///< trees ask only about the first so many; 0: about all
};

struct LearntTrees {
    std::int32_t start = 0;
    std::vector<BoostedTree> trees;
    [[nodiscard]] std::int32_t logOddsOf(const float* features) const { return logOdds(trees, start, features); }
};

/// Gradient boosting on the logistic loss, with at most 255 limits a feature. The same samples give the same trees for any number of
/// threads.
[[nodiscard]] LearntTrees learntTrees(const TreeSamples& samples, const BoostingChoices& choices, int threads);

/// How well log odds answer samples.
struct AnswerQuality {
    double auc = 0;           ///< weighted area under the curve of hits against false alarms
    double precisionAt90 = 0; ///< of the samples that are said to be yes where nine of ten yes are found
    double calibration = 0;   ///< mean distance between the probability and the share of yes, over ten bins weighted by their samples
};
[[nodiscard]] AnswerQuality qualityOf(const TreeSamples& samples, const LearntTrees& trees);
/// "AUC .970, precision .940 at recall .9, calibration error .012"
[[nodiscard]] std::string qualityText(const AnswerQuality& quality);

/// The text of a file that gives `kStart` and `kTrees`.
[[nodiscard]] std::string treesText(const LearntTrees& trees, const std::string& madeBy);

} // namespace edgescan::lab
