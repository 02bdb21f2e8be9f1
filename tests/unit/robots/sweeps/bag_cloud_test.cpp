// Clouds through ROS bags: scanners with several beams become the grid of their rings and firings.
#include "core/files/open_save/open_scan.h"
#include "core/robots/bags/bag.h"
#include "core/robots/sweeps/bag_sweep.h"
#include "core/scan/grid/cartesian.h"
#include "tests/support/ros_clouds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace edgescan;
using namespace edgescan::test;

namespace {

Result<Scan> opened(const std::vector<std::vector<RosPoint>>& clouds, std::uint32_t height, const ReadingOptions& options = {}) {
    RosMessages messages;
    const auto topic = messages.topic("/points", "sensor_msgs/PointCloud2", Wire::CdrLittle);
    for (const auto& points : clouds) messages.message(topic, kRosStartNs, cloudOf(points, height, Wire::CdrLittle));
    const Bytes bytes = mcapOf(messages);
    return files::readScanBytes(std::as_bytes(std::span(bytes)), ".mcap", options);
}

/// The cell of each point of the room, whichever way lines and beams are counted.
void expectRoom(const Scan& scan, std::size_t points) {
    EXPECT_EQ(std::max(scan.lines(), scan.beams()), kFirings);
    EXPECT_EQ(std::min(scan.lines(), scan.beams()), kRings);
    EXPECT_EQ(countCells(scan)[static_cast<std::size_t>(CellState::Valid)], points);
}

} // namespace

TEST(RosBagCloud, RingsAndFiringsAreTheGrid) {
    std::vector<RosPoint> points;
    std::size_t measured = 0;
    for (int firing = 0; firing < kFirings; ++firing) {
        for (int ring = 0; ring < kRings; ++ring) {
            if (isMissing(ring, firing)) continue;
            points.push_back(pointOf(ring, firing));
            ++measured;
            if ((firing + ring) % 50 != 0) continue;
            points.push_back(points.back()); // a second return
            for (float* part : {&points.back().x, &points.back().y, &points.back().z}) *part *= 0.5F;
        }
    }
    const auto scan = opened({points}, 1);
    ASSERT_TRUE(scan) << scan.error().sentence();
    expectRoom(*scan, measured);
    EXPECT_EQ(scan->attached.size(), points.size() - measured);
    EXPECT_GT(scan->intensity.size(), 0U);
}

TEST(RosBagCloud, AnOrganisedCloudKeepsItsRowsAndColumns) {
    for (const bool staggered : {false, true}) {
        std::vector<RosPoint> points;
        std::size_t measured = 0;
        for (int ring = 0; ring < kRings; ++ring) {
            for (int firing = 0; firing < kFirings; ++firing) {
                const double offset = staggered ? (ring % 4) * 3.1 : 0.0; // as an Ouster's rings are turned against each other
                points.push_back(isMissing(ring, firing) ? RosPoint{.ring = static_cast<std::uint16_t>(ring)}
                                                         : pointOf(ring, firing, offset));
                measured += isMissing(ring, firing) ? 0 : 1;
            }
        }
        const auto scan = opened({points}, kRings);
        ASSERT_TRUE(scan) << scan.error().sentence();
        expectRoom(*scan, measured);
    }
}

TEST(RosBagCloud, TheCloudWithMostPointsOpensOrTheOneThatIsChosen) {
    std::vector<std::vector<RosPoint>> clouds(3);
    for (int cloud = 0; cloud < 3; ++cloud) {
        const int firings = cloud == 1 ? kFirings : kFirings / 2;
        for (int firing = 0; firing < firings; ++firing) {
            for (int ring = 0; ring < kRings; ++ring) clouds[static_cast<std::size_t>(cloud)].push_back(pointOf(ring, firing));
        }
    }
    const auto largest = opened(clouds, 1);
    ASSERT_TRUE(largest) << largest.error().sentence();
    EXPECT_EQ(largest->cells(), static_cast<std::size_t>(kRings * kFirings));
    ReadingOptions options;
    options.scanIndex = 0;
    const auto first = opened(clouds, 1, options);
    ASSERT_TRUE(first) << first.error().sentence();
    EXPECT_EQ(first->cells(), static_cast<std::size_t>(kRings * kFirings / 2));
    options.scanIndex = 3;
    EXPECT_FALSE(opened(clouds, 1, options));
}

TEST(RosBagCloud, FiringsAreCountedOverGapsAndDelays) {
    std::vector<std::uint32_t> rings, expected;
    std::vector<double> times;
    for (std::uint32_t firing = 0; firing < 500; ++firing) {
        for (std::uint32_t ring = 0; ring < 5; ++ring) {
            if ((firing + ring) % 3 == 0 || (firing > 100 && firing < 180)) continue;
            rings.push_back(ring);
            expected.push_back(firing);
            times.push_back(1e9 + firing * 1000.0 + ring * 190.0);
        }
    }
    const auto firings = robots::firingsOf(rings, times);
    ASSERT_TRUE(firings);
    for (std::size_t n = 1; n < expected.size(); ++n) ASSERT_EQ((*firings)[n] - (*firings)[0], expected[n] - expected[0]) << n;
    EXPECT_FALSE(robots::firingsOf(std::vector<std::uint32_t>(50, 0), std::vector<double>(50, 1.0)));
    times[7] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(robots::firingsOf(rings, times));
}
