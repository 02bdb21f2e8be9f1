// Scans from two stations of a simulated bell: the surfaces correct a wrong pose, and the truth is known.
#include "core/inspect/registration/cloud_distance.h"
#include "core/inspect/registration/scan_alignment.h"
#include "tests/support/stations.h"

#include <gtest/gtest.h>

using namespace edgescan;
using namespace edgescan::inspect;

TEST(Stations, AScanFromAnotherStationIsOfTheSameScene) {
    const test::Stations stations = test::twoStations(3, 1.0, 0.0, 0.0);
    const auto distances = cloudDistances(stations.moved.pointsM, PointIndex(stations.fixed.pointsM), 1.0);
    EXPECT_LT(distanceHistogram(distances, 1.0, 50).medianM, 0.06); // half of the spacing of the points
    const test::Stations wrong = test::twoStations(3, 1.0, 0.4, 4.0);
    const auto off = cloudDistances(wrong.moved.pointsM, PointIndex(wrong.fixed.pointsM), 1.0);
    EXPECT_GT(distanceHistogram(off, 1.0, 50).medianM, 0.1);
}

TEST(Stations, SurfacesCorrectAWrongPose) {
    for (const std::uint64_t seed : {1, 2, 3}) {
        const test::Stations stations = test::twoStations(seed, 1.5, 0.15, 1.5);
        const auto aligned = alignScans(stations.fixed, stations.moved, 0.5);
        ASSERT_TRUE(aligned) << aligned.error().sentence();
        EXPECT_LT(stations.leftM(aligned->correction), 0.02) << seed << ": " << stations.leftM(RigidTransform{}) << " m before";
        EXPECT_LT(stations.leftDeg(aligned->correction), 0.2) << seed;
        EXPECT_LT(aligned->residualM, aligned->residualBeforeM);
    }
}
