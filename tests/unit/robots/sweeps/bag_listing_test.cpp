// What a list of a bag's topics says that are not scans.
#include "core/robots/sweeps/bag_topics.h"
#include "tests/support/ros_bags.h"

#include <gtest/gtest.h>

using namespace edgescan;
using namespace edgescan::test;

TEST(BagListing, AnInertialUnitIsNamedAndNotUsed) {
    for (const double covariance : {0.0, -1.0}) {
        RosMessages messages;
        const auto imu = messages.topic("/imu/data", "sensor_msgs/Imu", Wire::Ros1);
        const auto poses = messages.topic("/pose", "geometry_msgs/PoseStamped", Wire::Ros1);
        RosWriter unit(Wire::Ros1), pose(Wire::Ros1);
        unit.header(1'000'000'000, "/imu_link").put(0.0).put(0.0).put(0.0).put(1.0).put(covariance);
        for (int n = 0; n < 8 + 3 + 9 + 3 + 9; ++n) unit.put(0.0);
        pose.header(1'000'000'000, "/map");
        for (int n = 0; n < 7; ++n) pose.put(1.0);
        messages.message(imu, 1'000'000'000, unit.bytes());
        messages.message(poses, 1'000'000'000, pose.bytes());
        const Bytes bytes = bag1Of(messages);
        const auto bag = robots::readRosBag(bytes, "test.bag");
        ASSERT_TRUE(bag);
        const auto listing = robots::listingOf(*bag);
        ASSERT_EQ(listing.topics.size(), 2U);
        EXPECT_FALSE(listing.topics[0].isScan);
        EXPECT_EQ(listing.topics[0].frame, "imu_link");
        EXPECT_EQ(listing.topics[0].gives.starts_with("orientation, turn rates"), covariance == 0.0) << listing.topics[0].gives;
        EXPECT_NE(listing.topics[0].gives.find("not used"), std::string::npos);
        EXPECT_EQ(listing.topics[1].gives, "poses in the frame map");
    }
}
