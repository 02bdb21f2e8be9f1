// Boosted trees against a version that is easy to read, and log odds in per cent.
#include "core/base/boosted_trees.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace edgescan {
namespace {

std::int32_t leafOf(const BoostedTree& tree, const std::vector<float>& features, std::size_t question = 0) {
    if (question >= BoostedTree::kQuestions) return tree.leaf[question - BoostedTree::kQuestions];
    const bool low = features[tree.feature[question]] <= tree.limit[question];
    return leafOf(tree, features, low ? 2 * question + 1 : 2 * question + 2);
}

std::vector<BoostedTree> randomTrees(std::mt19937& random, int features) {
    std::vector<BoostedTree> trees(12);
    for (BoostedTree& tree : trees) {
        for (std::size_t n = 0; n < BoostedTree::kQuestions; ++n) {
            tree.feature[n] = static_cast<std::uint8_t>(random() % static_cast<unsigned>(features));
            tree.limit[n] = static_cast<float>(random() % 100);
        }
        for (std::int32_t& leaf : tree.leaf) leaf = static_cast<std::int32_t>(random() % 4001) - 2000;
    }
    return trees;
}

TEST(BoostedTrees, FollowTheirQuestions) {
    std::mt19937 random(3);
    constexpr int kFeatures = 7;
    const std::vector<BoostedTree> trees = randomTrees(random, kFeatures);
    for (int n = 0; n < 500; ++n) {
        std::vector<float> features(kFeatures);
        for (float& feature : features) feature = static_cast<float>(random() % 100);
        std::int32_t sum = -77;
        for (const BoostedTree& tree : trees) sum += leafOf(tree, features);
        EXPECT_EQ(logOdds(trees, -77, features.data()), sum);
    }
}

TEST(BoostedTrees, WhatTheFeaturesAddedIsTheLeafMinusTheMean) {
    std::mt19937 random(5);
    constexpr int kFeatures = 4;
    const std::vector<BoostedTree> trees = randomTrees(random, kFeatures);
    std::int32_t mean = 0;
    for (const BoostedTree& tree : trees) {
        double sum = 0;
        for (const std::int32_t leaf : tree.leaf) sum += leaf;
        mean += static_cast<std::int32_t>(sum / static_cast<double>(BoostedTree::kLeaves));
    }
    const std::vector<float> features{10, 40, 60, 90};
    const std::vector<std::int32_t> added = addedByFeature(trees, features);
    std::int32_t sum = 0;
    for (const std::int32_t value : added) sum += value;
    EXPECT_NEAR(sum, logOdds(trees, 0, features.data()) - mean, 12 * BoostedTree::kDepth); // halves are rounded
}

TEST(BoostedTrees, LogOddsArePerCents) {
    EXPECT_EQ(percentOf(0), 50);
    EXPECT_EQ(percentOf(-1000000), 0);
    EXPECT_EQ(percentOf(1000000), 100);
    for (std::int32_t odds = -40000; odds <= 40000; odds += 7) {
        const double share = 100 / (1 + std::exp(-static_cast<double>(odds) / kLogOddsUnit));
        EXPECT_NEAR(percentOf(odds), share, 0.51) << odds;
        EXPECT_LE(percentOf(odds), percentOf(odds + 7));
    }
}

} // namespace
} // namespace edgescan
