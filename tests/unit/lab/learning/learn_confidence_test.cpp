// The fit of the confidence of rocks.
#include "app/lab/learning/learn_confidence.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace edgescan::lab {
namespace {

TEST(LearnConfidence, FindsTheWeightsThatMadeTheSamples) {
    const rocks::ConfidenceWeights truth{-1.0, 0.5, 0.0, 1.5, -0.25};
    std::mt19937 random(1);
    const auto share = [&] { return static_cast<double>(random()) / 4294967296.0; };
    std::vector<ConfidenceLesson> samples;
    for (int n = 0; n < 20000; ++n) {
        ConfidenceLesson sample;
        for (double& input : sample.inputs) input = 4 * share() - 2;
        sample.right = share() < rocks::confidenceOf(sample.inputs, truth);
        samples.push_back(sample);
    }
    const rocks::ConfidenceWeights found = fittedConfidence(samples);
    for (std::size_t n = 0; n < truth.size(); ++n) EXPECT_NEAR(found[n], truth[n], 0.1) << n;
    EXPECT_EQ(fittedConfidence(samples), found);
}

TEST(LearnConfidence, FalseRocksOfABareWallAreSamples) {
    sim::SimulationSettings settings;
    settings.scene = "empty";
    settings.wallKind = "blocky";
    settings.lines = 250;
    settings.beams = 286;
    settings.truth = true;
    const auto simulation = sim::simulate(settings);
    ASSERT_TRUE(simulation);
    std::vector<ConfidenceLesson> samples;
    const RockLesson lesson = rockLesson(std::make_shared<const Scan>(simulation->scan), simulation->truth->object);
    addConfidenceSamples(lesson, rocks::mergeTree(lesson.segments), 1.0, samples);
    EXPECT_FALSE(samples.empty());
    EXPECT_TRUE(std::ranges::none_of(samples, &ConfidenceLesson::right));
    // The program knows that these are hardly rocks.
    for (const ConfidenceLesson& sample : samples) EXPECT_LT(rocks::confidenceOf(sample.inputs, rocks::confidenceWeights()), 0.85);
}

TEST(LearnConfidence, TheTextHasEveryWeight) {
    EXPECT_EQ(confidenceWeightsText({1, -2.5, 0.25, 0, 4}, "a command"),
              "// Made by `a command`; do not edit.\n1.000, -2.500, 0.250, 0.000, 4.000,\n");
}

} // namespace
} // namespace edgescan::lab
