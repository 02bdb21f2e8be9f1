// True borders of a known scene, and what the shipped trees say of a bell that they have not seen.
#include "app/lab/learning/learn_edges.h"

#include "app/lab/sim/scene.h"
#include "core/edges/rock_borders/rock_borders.h"
#include "tests/support/scored_scene.h"

#include <gtest/gtest.h>

namespace edgescan::lab {
namespace {

TEST(LearnEdges, BordersAreNearOutlinesAndBetweenBodies) {
    sim::TruthSet truth;
    truth.edges.edgeClass = Grid<std::uint8_t>(40, 40);
    truth.edges.ignore = Grid<std::uint8_t>(40, 40);
    truth.object = Grid<std::uint16_t>(40, 40, sim::kWallObject);
    truth.edges.edgeClass.at(10, 10) = static_cast<std::uint8_t>(sim::EdgeClass::Occluding);
    truth.edges.edgeClass.at(30, 10) = static_cast<std::uint8_t>(sim::EdgeClass::Crease);
    for (int i = 20; i < 26; ++i) {
        for (int j = 20; j < 26; ++j) truth.object.at(i, j) = sim::kFirstRock; // 36 cells
    }
    truth.object.at(35, 35) = sim::kFirstRock + 1; // too small to be scored
    const Grid<std::uint8_t> border = trueBorders(truth);
    struct Row {
        int line, beam;
        bool border;
    };
    for (const Row& row : {Row{10, 12, true},
                           {11, 11, true},
                           {10, 13, false},
                           {12, 11, false},
                           {30, 10, false},
                           {20, 22, true},
                           {18, 22, true},
                           {17, 22, false},
                           {22, 22, false},
                           {35, 35, false}})
        EXPECT_EQ(border.at(row.line, row.beam) != 0, row.border) << row.line << ", " << row.beam;
}

TEST(LearnEdges, TheShippedTreesKnowTheBordersOfAnUnseenBell) {
    for (const char* scene : {"hangup", "pile"}) {
        const sim::Simulation bell = test::scoredScene(scene, 99117, 300, 343);
        TreeSamples samples;
        addEdgeSamples(std::make_shared<const Scan>(bell.scan), sim::truthSetOf(bell), 5000, samples);
        ASSERT_GT(samples.count(), 1000U);
        const edges::BorderModel model = edges::borderModel();
        const AnswerQuality quality = qualityOf(samples, {model.start, {model.trees.begin(), model.trees.end()}});
        EXPECT_GT(quality.auc, 0.93) << scene;
        EXPECT_LT(quality.calibration, 0.1) << scene;
    }
}

TEST(LearnEdges, TakesNoMoreSamplesThanAsked) {
    const sim::Simulation bell = test::scoredScene("pile", 3, 120, 140);
    TreeSamples samples;
    addEdgeSamples(std::make_shared<const Scan>(bell.scan), sim::truthSetOf(bell), 100, samples);
    EXPECT_LE(samples.count(), 100U);
    EXPECT_GT(samples.count(), 50U);
}

} // namespace
} // namespace edgescan::lab
