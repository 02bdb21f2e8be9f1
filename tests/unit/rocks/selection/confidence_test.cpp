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
    EXPECT_EQ(inputs[1][0], 0.4);
    EXPECT_EQ(inputs[1][1], 12.0); // within -6 .. 12
    EXPECT_EQ(inputs[1][2], inputs[2][2]);
    EXPECT_DOUBLE_EQ(inputs[1][3], (5 * 8.0 + 5 * -6.0) / 10);
    EXPECT_DOUBLE_EQ(inputs[2][3], 5 * 12.0 / 10);
}

TEST(Confidence, RisesWithTheScoresOfARockAndOfTheOthers) {
    for (std::size_t n = 1; n < confidenceWeights().size(); ++n) EXPECT_GT(confidenceWeights()[n], 0.0) << n;
    const auto of = [](const RegionMap& map) { return confidenceOf(confidenceInputs(map)[2], confidenceWeights()); };
    // The same rock is less sure where the other one is doubtful.
    EXPECT_LT(of(pair(1.0, 0.5)), of(pair(6.0, 12.0)));
}

TEST(Confidence, AScanWithoutRocksHasInputs) {
    RegionMap map;
    map.regions = {Region{}, region(RegionKind::NotRock, 2.0, -9.0)};
    EXPECT_EQ(confidenceInputs(map)[1][2], 0.0);
}

} // namespace
} // namespace edgescan::rocks
