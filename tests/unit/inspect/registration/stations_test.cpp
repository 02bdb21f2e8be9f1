// Scans from two stations of a simulated bell: the surfaces correct a wrong pose, and the truth is known.
#include "core/inspect/registration/point_index.h"
#include "core/inspect/registration/scan_alignment.h"
#include "core/inspect/registration/stations.h"
#include "tests/support/stations.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

using namespace edgescan;
using namespace edgescan::inspect;

TEST(Stations, AScanFromAnotherStationIsOfTheSameScene) {
    const test::Stations stations = test::twoStations(3, 1.0, 0.0, 0.0);
    const auto distances = cloudDistances(stations.moved.pointsM, PointIndex(stations.fixed.pointsM), 1.0);
    EXPECT_LT(distanceHistogram(distances, 1.0, 50).medianM, 0.06); // half of the spacing of the points
    const PlacedScan wrong = corrected(stations.moved, {rotationRpyDeg({0, 4, 0}), Eigen::Vector3d(0.4, 0, 0)});
    const auto off = cloudDistances(wrong.pointsM, PointIndex(stations.fixed.pointsM), 1.0);
    EXPECT_GT(distanceHistogram(off, 1.0, 50).medianM, 0.1);
}

TEST(Stations, SurfacesCorrectAWrongPose) {
    const test::Stations stations = test::twoStations(1, 1.5, 0.15, 1.5);
    const auto aligned = alignScans(stations.fixed, stations.moved, 0.5);
    ASSERT_TRUE(aligned) << aligned.error().sentence();
    EXPECT_LT(stations.leftM(aligned->correction), 0.02) << stations.leftM(RigidTransform{}) << " m before";
    EXPECT_LT(stations.leftDeg(aligned->correction), 0.2);
    EXPECT_LT(aligned->residualM, aligned->residualBeforeM);
}

TEST(Stations, ThreePairsGiveTheTransform) {
    const RigidTransform truth{rotationRpyDeg({10, -20, 70}), Eigen::Vector3d(1, -2, 0.5)};
    std::vector<PointPair> pairs;
    for (const Eigen::Vector3d& p : {Eigen::Vector3d(1, 2, 6), Eigen::Vector3d(-2, 1, 5), Eigen::Vector3d(0, -3, 7)})
        pairs.push_back({truth * p, p});
    const auto found = transformOfPairs(pairs);
    ASSERT_TRUE(found);
    EXPECT_LT((found->rotation - truth.rotation).norm(), 1e-12);
    EXPECT_LT((found->translationM - truth.translationM).norm(), 1e-12);
    EXPECT_FALSE(transformOfPairs(std::vector<PointPair>(pairs.begin(), pairs.begin() + 2)));
    for (std::size_t n = 0; n < 3; ++n) pairs[n] = {Eigen::Vector3d::UnitX() * n, Eigen::Vector3d::UnitX() * n};
    EXPECT_FALSE(transformOfPairs(pairs)) << "on one line";
}

TEST(Stations, ALayerIsPlacedByThreePointsAndThenByItsSurfaces) {
    const RigidTransform place{rotationRpyDeg({8, -6, 35}), Eigen::Vector3d(1.2, -0.5, 0.1)};
    const auto first = test::scanFrom({}, 4, 0, 100, 120), other = test::scanFrom(place, 4, 1, 100, 120);
    StationRequest wish;
    for (const Eigen::Vector3d& p : {Eigen::Vector3d(1.5, 0.5, 6), Eigen::Vector3d(-1.5, 1, 5), Eigen::Vector3d(0, -2, 6)})
        wish.pairs.push_back({p + 0.1 * Eigen::Vector3d(p.y(), p.x(), 1).normalized(), inverse(place) * p}); // clicks are 10 cm off
    const auto station = stationOf(first, other, wish);
    ASSERT_TRUE(station) << station.error().sentence();
    EXPECT_EQ(station->by, StationBasis::Pairs);
    ASSERT_TRUE(station->fit);
    EXPECT_TRUE(station->corrected);
    EXPECT_LT((station->placed.sensorM - place.translationM).norm(), 0.03);
    EXPECT_LT(station->fit->residualM, 0.02);
    EXPECT_TRUE(station->warnings.empty()) << station->warnings.front();
    // Without a start the frames of the scanners are taken: a place without a warning is the right one.
    const auto alone = stationOf(first, other);
    EXPECT_TRUE(!alone || !alone->warnings.empty() || (alone->placed.sensorM - place.translationM).norm() < 0.05);
}

TEST(Stations, TheSameRocksAreFoundInTwoSweeps) {
    sim::SimulationSettings settings;
    settings.seed = 6;
    settings.lines = 200;
    settings.beams = 240;
    settings.truth = true;
    std::array<PlacedScan, 2> scans;
    std::array<std::vector<int>, 2> rocks;
    for (std::size_t n = 0; n < 2; ++n) {
        settings.repeat = static_cast<int>(n);
        auto simulated = sim::simulate(settings);
        ASSERT_TRUE(simulated);
        for (const std::uint16_t object : simulated->truth->object.cells)
            rocks[n].push_back(object < 2 ? 0 : n == 0 ? object : 10000 - object); // other labels in the other scan
        scans[n] = placedBy(std::make_shared<const Scan>(std::move(simulated->scan)), {});
    }
    const auto same = sameRocks(scans[0], rocks[0], scans[1], rocks[1], 0.1);
    EXPECT_GT(same.size(), 100U);
    std::size_t right = 0;
    for (const SameRock& one : same) right += one.other == 10000 - one.first ? 1 : 0;
    EXPECT_GT(static_cast<double>(right), 0.98 * static_cast<double>(same.size()));
}
