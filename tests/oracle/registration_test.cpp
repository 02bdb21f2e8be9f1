// Our registration of two stations compared with PCL's generalised ICP, on simulated bells with known truth. Both start at the same wrong
// pose.
#include "core/inspect/registration/scan_alignment.h"
#include "tests/support/stations.h"

#include <gtest/gtest.h>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/registration/gicp.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <vector>

using namespace edgescan;
using Eigen::Vector3d;

namespace {

constexpr double kReachM = 0.5;

struct Outcome {
    double leftMm = 0, leftDeg = 0, seconds = 0;
};

double secondsSince(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

Outcome byUs(const test::Stations& stations) {
    const auto start = std::chrono::steady_clock::now();
    const auto aligned = inspect::alignScans(stations.fixed, stations.moved, kReachM);
    const double seconds = secondsSince(start);
    const RigidTransform found = aligned ? aligned->correction : RigidTransform{};
    return {1000 * stations.leftM(found), stations.leftDeg(found), seconds};
}

pcl::PointCloud<pcl::PointXYZ>::Ptr cloudOf(const inspect::PlacedScan& placed) {
    pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
    for (const Vector3d& p : placed.pointsM) {
        if (p.allFinite()) cloud->emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z()));
    }
    return cloud;
}

Outcome byPcl(const test::Stations& stations) {
    const auto start = std::chrono::steady_clock::now();
    pcl::GeneralizedIterativeClosestPoint<pcl::PointXYZ, pcl::PointXYZ> icp;
    icp.setInputSource(cloudOf(stations.moved));
    icp.setInputTarget(cloudOf(stations.fixed));
    icp.setMaxCorrespondenceDistance(kReachM);
    icp.setMaximumIterations(60);
    icp.setTransformationEpsilon(1e-6);
    pcl::PointCloud<pcl::PointXYZ> moved;
    icp.align(moved);
    const Eigen::Matrix4d m = icp.getFinalTransformation().cast<double>();
    const RigidTransform found{m.topLeftCorner<3, 3>(), m.topRightCorner<3, 1>()};
    return {1000 * stations.leftM(found), stations.leftDeg(found), secondsSince(start)};
}

double medianOf(std::vector<double> values) {
    std::ranges::sort(values);
    return values[values.size() / 2];
}

} // namespace

TEST(Registration, OfStationsComparedWithGeneralisedIcp) {
    struct Start {
        double apartM, errorM, errorDeg;
    };
    for (const Start& from : {Start{0.8, 0.05, 0.5}, Start{1.5, 0.15, 1.5}}) {
        std::vector<double> ours, pcls, oursDeg, pclsDeg, oursS, pclsS;
        for (const std::uint64_t seed : {11, 12, 13}) {
            const test::Stations stations = test::twoStations(seed, from.apartM, from.errorM, from.errorDeg, 140, 170);
            const Outcome our = byUs(stations), pcl = byPcl(stations);
            std::printf("stations %.1f m apart, pose off by %.2f m and %.1f deg, seed %d: ours %.1f mm %.3f deg %.2f s, GICP %.1f mm %.3f "
                        "deg %.2f s\n",
                        from.apartM, from.errorM, from.errorDeg, static_cast<int>(seed), our.leftMm, our.leftDeg, our.seconds, pcl.leftMm,
                        pcl.leftDeg, pcl.seconds);
            ours.push_back(our.leftMm);
            pcls.push_back(pcl.leftMm);
            oursDeg.push_back(our.leftDeg);
            pclsDeg.push_back(pcl.leftDeg);
            oursS.push_back(our.seconds);
            pclsS.push_back(pcl.seconds);
        }
        std::printf("  median: ours %.1f mm %.3f deg %.2f s, GICP %.1f mm %.3f deg %.2f s\n", medianOf(ours), medianOf(oursDeg),
                    medianOf(oursS), medianOf(pcls), medianOf(pclsDeg), medianOf(pclsS));
        EXPECT_LT(medianOf(ours), 10.0) << from.errorM; // the noise of one range is 7 mm at 6 m
    }
}
