// The points on both sides of a cell, and the lines through them.
#include "core/edges/explain/edge_profile.h"

#include "tests/support/scans.h"

#include <gtest/gtest.h>

#include <cmath>

namespace edgescan::edges {
namespace {

/// A wall 4 m in front, at right angles to the middle beam; from beam `split` on `step` metres farther.
Scan walls(int split, double step) {
    return test::makeScan(9, 61, [=](int, int beam) {
        const double deg = 60.0 + beam;
        return static_cast<float>(1000.0 * (beam < split ? 4.0 : 4.0 + step) / std::sin(deg * 3.14159265358979323846 / 180.0));
    });
}

Scan walled(int split, double step) {
    Scan scan = walls(split, step);
    auto& polar = std::get<PolarGeometry>(scan.geometry);
    for (std::size_t j = 0; j < polar.beamDeg.size(); ++j) polar.beamDeg[j] = 60.0 + static_cast<double>(j);
    for (double& deg : polar.lineDeg) deg = 0.0;
    return scan;
}

TEST(EdgeProfile, OneFarPointDoesNotFlattenThePicture) {
    const auto profileOf = [](int far, double farM) { // a step of 0.2 m; behind the cell, so many points at `farM`
        EdgeProfile profile;
        for (int n = -12; n <= 12; ++n)
            profile.points.push_back({0, n < 0 ? -1 : n > 0 ? 1 : 0, 0.02 * n, n > 6 - far && n <= 6 ? farM : n > 0 ? 0.2 : 0.0});
        return profile;
    };
    for (const int far : {1, 2}) {
        EXPECT_LT(depthsShown(profileOf(far, 13.0)).mostM, 0.25) << far;
        EXPECT_GT(depthsShown(profileOf(far, -3.0)).leastM, -0.05) << far;
    }
    EXPECT_DOUBLE_EQ(depthsShown(profileOf(6, 13.0)).mostM, 13.0) << "a jump is shown";
    EXPECT_DOUBLE_EQ(depthsShown(profileOf(0, 0.0)).mostM, 0.2);
    EXPECT_DOUBLE_EQ(depthsShown({}).mostM, 0.0);
}

} // namespace

TEST(EdgeProfile, AJumpHasALineOnEitherSideAsFarApartAsTheWalls) {
    const Scan scan = walled(31, 0.5);
    const std::size_t k = scan.rangeMm.index(4, 30); // straight ahead, the last cell of the near wall
    const EdgeProfile profile = edgeProfile(scan, k, Along::Beams);
    ASSERT_EQ(profile.points.size(), 25U);
    ASSERT_TRUE(profile.sides[0] && profile.sides[1]);
    for (const ProfilePoint& p : profile.points) {
        EXPECT_EQ(p.side, p.cell < k ? -1 : p.cell > k ? 1 : 0);
        EXPECT_NEAR(p.awayM, p.cell <= k ? 0.0 : 0.5, 2e-3); // ranges are whole millimetres
        const double deg = static_cast<double>(p.cell) - static_cast<double>(k);
        EXPECT_NEAR(std::abs(p.acrossM), std::abs((p.cell <= k ? 4.0 : 4.5) * std::tan(deg * 3.14159265358979323846 / 180.0)), 2e-3);
    }
    EXPECT_EQ(profile.sides[0]->points, 6);
    for (const double away : {profile.sides[0]->fromAwayM, profile.sides[0]->toAwayM}) EXPECT_NEAR(away, 0.0, 2e-3);
    for (const double away : {profile.sides[1]->fromAwayM, profile.sides[1]->toAwayM}) EXPECT_NEAR(away, 0.5, 2e-3);
}

// A jump within the points of a side: its line is that of one surface, and not a slope from one to the other.
TEST(EdgeProfile, NoLineCrossesAJump) {
    for (const int split : {31, 32, 33, 34, 35, 36}) {
        const Scan scan = walled(split, 2.0);
        const EdgeProfile profile = edgeProfile(scan, scan.rangeMm.index(4, 30), Along::Beams);
        ASSERT_TRUE(profile.sides[0] && profile.sides[1]) << split;
        EXPECT_LT(std::abs(profile.sides[1]->fromAwayM - profile.sides[1]->toAwayM), 0.05) << split;
        const double near = split >= 34 ? 0.0 : 2.0;
        EXPECT_NEAR(profile.sides[1]->fromAwayM, near, 0.1) << split;
    }
}

TEST(EdgeProfile, WhatHasNoRangeIsLeftOut) {
    Scan scan = walled(61, 0.0);
    for (int beam = 31; beam < 61; ++beam) scan.state.at(4, beam) = CellState::NoReturn;
    const EdgeProfile profile = edgeProfile(scan, scan.rangeMm.index(4, 30), Along::Beams);
    EXPECT_EQ(profile.points.size(), 13U);
    EXPECT_TRUE(profile.sides[0] && !profile.sides[1]);
    EXPECT_TRUE(edgeProfile(scan, scan.rangeMm.index(4, 40), Along::Beams).points.empty());
    EXPECT_TRUE(edgeProfile(scan, scan.rangeMm.index(4, 30), Along::Lines).points.size() <= 9U);
}

} // namespace edgescan::edges
