// The confidence of a region depends on its outline, on its neighbours and on the other rocks.
#include "core/rocks/selection/confidence.h"

#include <gtest/gtest.h>

namespace edgescan::rocks {
namespace {

Region region(RegionKind kind, double evidence, double score) {
    Region made;
    made.kind = kind;
    made.evidence = evidence;
    made.nearShare = 0.4;
    made.score = score;
    made.outlineCracks = 10;
    made.bulge = 0.06;
    made.edgeShare = 0.95;
    made.depthRatio = 0.2;
    made.boxShare = 0.75;
    made.sums.cells = 500;
    made.sums.sumM = {0, 500 * 5.0, 0}; // at 5 m
    made.sums.areaM2 = 0.25;
    return made;
}

// Two rocks that share half of their outline, and a wall.
RegionMap pair(double evidence, double score) {
    RegionMap map;
    map.regions = {Region{}, region(RegionKind::Rock, evidence, score), region(RegionKind::Rock, 5.0, 8.0),
                   region(RegionKind::NotRock, 2.0, -9.0)};
    RegionBorder shared, wall;
    shared.a = 1, shared.b = 2, shared.cracks = 5;
    wall.a = 1, wall.b = 3, wall.cracks = 5;
    map.borders = {shared, wall};
    return map;
}

TEST(Confidence, InputsAreThoseOfTheRegionItsNeighboursAndAllRocks) {
    const auto inputs = confidenceInputs(pair(4.0, 20.0));
    EXPECT_EQ(inputs[1][0], 0.4F);
    EXPECT_EQ(inputs[1][1], 12.0F); // within -6 .. 12
    EXPECT_EQ(inputs[1].back(), inputs[2].back());
    EXPECT_FLOAT_EQ(inputs[1][2], (5 * 8.0F + 5 * -6.0F) / 10);
    EXPECT_FLOAT_EQ(inputs[2][2], 5 * 12.0F / 10);
}

TEST(Confidence, RisesWithTheScoresOfARockAndOfTheOthers) {
    const auto of = [](const RegionMap& map) { return confidenceOf(confidenceInputs(map)[2]); };
    // The same rock is less sure where the other one is doubtful.
    EXPECT_LT(of(pair(1.0, 0.5)), of(pair(6.0, 12.0)));
}

TEST(Confidence, WhatTheOtherRocksAreChangesItSmoothly) {
    ConfidenceInputs inputs = confidenceInputs(pair(3.0, 3.0))[2];
    double before = 0;
    for (inputs.back() = 0; inputs.back() <= 2; inputs.back() += 0.05F) {
        const double now = confidenceOf(inputs);
        EXPECT_GT(now, before);
        if (before > 0) EXPECT_LT(now, before + 0.05);
        before = now;
    }
}

TEST(Confidence, FallsWhereTheNextMergeIsNearlyAsCheap) {
    const auto with = [](double above) {
        RegionMap map = pair(5.0, 8.0);
        map.regions[2].levelsAbove = above;
        map.regions[2].score = 2.0;
        map.regions[2].evidence = 3.0;
        return confidenceOf(confidenceInputs(map)[2]);
    };
    EXPECT_LT(with(0.1), with(kMostLevels));
}

TEST(Confidence, AScanWithoutRocksHasInputs) {
    RegionMap map;
    map.regions = {Region{}, region(RegionKind::NotRock, 2.0, -9.0)};
    EXPECT_EQ(confidenceInputs(map)[1].back(), 0.0F);
    EXPECT_FLOAT_EQ(confidenceInputs(map)[1][11], 0.25F / 25);
}

} // namespace
} // namespace edgescan::rocks
