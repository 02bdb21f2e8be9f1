// Trees learn what is there to learn, the same with any number of threads, and survive being written.
#include "app/lab/learning/boosting.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

namespace edgescan::lab {
namespace {

// Yes inside a ring of the first two features; the third one says nothing, the fourth one is the same everywhere.
TreeSamples ring(unsigned seed, int count, double wrong = 0) {
    std::mt19937 random(seed);
    const auto next = [&random] { return static_cast<float>(random() % 2000) / 1000.0F - 1.0F; };
    TreeSamples samples;
    for (int n = 0; n < count; ++n) {
        const std::array<float, 4> features{next(), next(), next(), 1.0F};
        const float radius = std::hypot(features[0], features[1]);
        const bool inside = radius > 0.4F && radius < 0.8F;
        samples.add(features, inside != (static_cast<double>(random() % 1000) < 1000 * wrong), 1.0F);
    }
    return samples;
}

TEST(Boosting, LearnsARing) {
    const LearntTrees trees = learntTrees(ring(1, 20000), {}, 1);
    const AnswerQuality quality = qualityOf(ring(2, 5000), trees);
    EXPECT_GT(quality.auc, 0.98);
    EXPECT_GT(quality.precisionAt90, 0.9);
}

TEST(Boosting, IsCalibratedWhereSomeAnswersAreWrong) {
    const LearntTrees trees = learntTrees(ring(1, 40000, 0.2), {}, 1);
    EXPECT_LT(qualityOf(ring(2, 20000, 0.2), trees).calibration, 0.06);
}

TEST(Boosting, IsTheSameWithAnyNumberOfThreads) {
    const TreeSamples samples = ring(4, 3000);
    EXPECT_EQ(treesText(learntTrees(samples, {}, 1), "x"), treesText(learntTrees(samples, {}, 3), "x"));
}

TEST(Boosting, TreesAddToWhatIsKnownBefore) {
    TreeSamples samples = ring(1, 20000);
    for (const std::uint8_t yes : samples.yes) samples.before.push_back(yes != 0 ? 8 * kLogOddsUnit : -8 * kLogOddsUnit);
    const LearntTrees trees = learntTrees(samples, {}, 1);
    EXPECT_EQ(trees.start, 0);
    EXPECT_LT(std::abs(trees.logOddsOf(samples.of(0))), 2 * kLogOddsUnit); // little is left to learn
    EXPECT_NEAR(qualityOf(samples, trees).auc, 1.0, 1e-9);
}

TEST(Boosting, AnUnaskedQuestionAddsNothing) {
    const LearntTrees trees = learntTrees(ring(1, 150), {.least = 1000}, 1); // no leaf is large enough
    for (const BoostedTree& tree : trees.trees) {
        for (const float limit : tree.limit) EXPECT_TRUE(std::isinf(limit));
        for (const std::int32_t leaf : tree.leaf) EXPECT_EQ(leaf, tree.leaf.front());
    }
    EXPECT_EQ(learntTrees({}, {}, 1).trees.size(), 0U);
}

TEST(Boosting, QualityOfKnownAnswers) {
    // One question: 10 samples below it with one yes, 10 above it with nine.
    LearntTrees trees;
    BoostedTree tree;
    tree.limit.fill(0.0F);
    for (std::size_t n = 0; n < BoostedTree::kLeaves; ++n)
        tree.leaf[n] = static_cast<std::int32_t>(std::lround(std::log(n < BoostedTree::kLeaves / 2 ? 1.0 / 9 : 9.0) * kLogOddsUnit));
    trees.trees.push_back(tree);
    TreeSamples samples;
    for (int n = 0; n < 20; ++n) samples.add(std::array<float, 1>{n < 10 ? -1.0F : 1.0F}, n == 0 || n > 10, 1.0F);
    const AnswerQuality quality = qualityOf(samples, trees);
    EXPECT_NEAR(quality.auc, 0.9, 1e-9);
    EXPECT_NEAR(quality.precisionAt90, 0.9, 1e-9);
    EXPECT_NEAR(quality.calibration, 0.0, 1e-3);
}

} // namespace
} // namespace edgescan::lab
