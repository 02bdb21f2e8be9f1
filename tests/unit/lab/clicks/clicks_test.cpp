// Random clicks near true edges: fewer lengths are off on the near side than at the clicked cells.
#include "app/lab/clicks/clicks.h"
#include "app/lab/clicks/throats.h"
#include "tests/support/scored_scene.h"

#include <gtest/gtest.h>

namespace edgescan::lab {
namespace {

TEST(Clicks, OnTheNearSideFewLengthsAreOff) {
    ClickScore all;
    for (const char* scene : {"hangup", "pile"}) all += scoreClicks(test::scoredScene(scene, 7101, 200, 255), 1000, 5);
    EXPECT_EQ(all.clicks, 2000U);
    EXPECT_GT(all.moved, 400U);
    EXPECT_GT(all.asClicked.shareOff(), 0.15);
    EXPECT_LT(all.nearSide.shareOff(), 0.08);
    EXPECT_LT(all.nearSide.behind, all.asClicked.behind / 4);
    EXPECT_LT(all.nearSide.silent * 500, all.nearSide.measured); // all others have a warning
    EXPECT_LT(all.nearSide.offSilently * 100, all.nearSide.measured);
    EXPECT_LT(all.nearSide.refused, all.asClicked.refused + 1);
}

TEST(Clicks, AreTheSameForOneSeed) {
    const sim::Simulation simulation = test::scoredScene("hangup", 3, 100, 127);
    EXPECT_EQ(scoreClicks(simulation, 200, 9).nearSide.off, scoreClicks(simulation, 200, 9).nearSide.off);
    EXPECT_EQ(scoreClicks(test::scoredScene("wall", 3, 40, 40), 100, 9).asClicked.behind, 0U);
}

TEST(Throats, AgreeWithinTheirToleranceWhenClickedAgain) {
    ThroatScore all;
    for (const char* scene : {"hangup", "pile"}) all += scoreThroats(test::scoredScene(scene, 7301, 200, 255), 12, 4, 5);
    EXPECT_EQ(all.ofAround.measured + all.ofAround.refused, 120U);
    ASSERT_GT(all.ofAround.measured, 80U);
    EXPECT_LE(all.ofAround.refused, all.ofClicks.refused);
    EXPECT_GT(all.ofClicks.shareOff(), 0.15); // the width of the two clicks alone depends on them
    EXPECT_LT(all.ofAround.shareOff(), 0.08);
    EXPECT_EQ(scoreThroats(test::scoredScene("wall", 3, 40, 40), 5, 2, 9).ofAround.measured, 0U);
}

} // namespace
} // namespace edgescan::lab
