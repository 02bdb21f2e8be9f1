// The samples of the confidence of rocks.
#include "app/lab/learning/learn_confidence.h"
#include "core/rocks/selection/confidence.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace edgescan::lab {
namespace {

TEST(LearnConfidence, FalseRocksOfABareWallAreSamples) {
    sim::SimulationSettings settings;
    settings.scene = "empty";
    settings.wallKind = "blocky";
    settings.lines = 250;
    settings.beams = 286;
    settings.truth = true;
    const auto simulation = sim::simulate(settings);
    ASSERT_TRUE(simulation);
    TreeSamples samples;
    const RockLesson lesson = rockLesson(std::make_shared<const Scan>(simulation->scan), simulation->truth->object);
    addConfidenceSamples(lesson, rocks::mergeTree(lesson.segments), 1.0F, samples);
    ASSERT_GT(samples.count(), 0U);
    EXPECT_EQ(std::ranges::count(samples.yes, 1), 0);
    // The program knows that these are hardly rocks.
    for (std::size_t n = 0; n < samples.count(); ++n) {
        rocks::ConfidenceInputs inputs{};
        std::copy_n(samples.of(n), inputs.size(), inputs.begin());
        EXPECT_LT(rocks::confidenceOf(inputs), 0.85);
    }
}

} // namespace
} // namespace edgescan::lab
