// Training of the network of borders.
#include "app/lab/learning/learn_borders.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace edgescan::lab {
namespace {

// What belongs to the other segment is decided by the product of two inputs: no straight rule finds it.
BorderSamples product(std::uint32_t seed, std::size_t count) {
    std::mt19937 random(seed);
    BorderSamples samples;
    for (std::size_t n = 0; n < count; ++n) {
        const std::size_t first = samples.features.size();
        for (std::size_t f = 0; f < rocks::kBorderFeatures; ++f)
            samples.features.push_back(static_cast<float>(random() % 2001) / 1000.0F - 1.0F);
        samples.belongs.push_back(samples.features[first + 3] * samples.features[first + 8] > 0 ? 1.0F : 0.0F);
    }
    return samples;
}

TEST(LearnBorders, LearnsWhatNoStraightRuleKnows) {
    const BorderSamples samples = product(1, 20000);
    const BorderTraining training{40, 1};
    const rocks::BorderNetwork network = trainedBorders(samples, training);
    EXPECT_GT(rightShare(network, samples), 0.9);
    EXPECT_GT(rightShare(network, product(2, 5000)), 0.85);
    const rocks::BorderNetwork again = trainedBorders(samples, training);
    EXPECT_EQ(again.first, network.first);
    EXPECT_EQ(again.thirdBias, network.thirdBias);
}

TEST(LearnBorders, TheTextHasEveryWeight) {
    rocks::BorderNetwork network;
    network.thirdBias = -0.5F;
    const std::string text = borderWeightsText(network, "a command");
    EXPECT_EQ(text.find("// Made by `a command`; do not edit.\n"), 0U);
    EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(text, 'F')), network.middle.size() + network.scale.size() + network.first.size() +
                                                                           network.firstBias.size() + network.second.size() +
                                                                           network.secondBias.size() + network.third.size() + 1);
    EXPECT_TRUE(text.ends_with("\n-5.00000e-01F\n"));
}

} // namespace
} // namespace edgescan::lab
