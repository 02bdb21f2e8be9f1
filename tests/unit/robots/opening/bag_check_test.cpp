// What of a bag can be read otherwise: its topics, its sweeps, its joints; every choice opens.
#include "core/files/open_save/open_scan.h"
#include "core/files/plausibility/opening_check.h"
#include "core/robots/sweeps/bag_topics.h"
#include "tests/support/ros_sweeps.h"
#include "tests/support/scans.h"

#include <gtest/gtest.h>

using namespace edgescan;
using namespace edgescan::files;
using namespace edgescan::test;

namespace {

Scan turned(int lines, int beams) {
    Scan scan = boxesScan(lines, beams, 3, 0.05);
    auto& polar = std::get<PolarGeometry>(scan.geometry);
    polar.axis = Axis::Sweep;
    for (int i = 0; i < lines; ++i) polar.lineDeg[static_cast<std::size_t>(i)] = 0.5 * (i < lines / 2 ? i : lines - 1 - i);
    return scan;
}

struct Bag {
    Bytes bytes;
    BagListing listing;
};
Bag bagOf(const RosMessages& messages) {
    Bag bag{bag1Of(messages), {}};
    const auto read = robots::readRosBag(bag.bytes, "test.bag");
    EXPECT_TRUE(read);
    bag.listing = robots::listingOf(*read);
    return bag;
}

Result<Scan> opened(const Bag& bag, const ReadingOptions& options = {}) {
    return readScanBytes(std::as_bytes(std::span(bag.bytes)), ".bag", options);
}

const OpeningPoint* named(const std::vector<OpeningPoint>& points, std::string_view what) {
    const auto found = std::ranges::find_if(points, [&](const OpeningPoint& point) { return what == point.what; });
    return found != points.end() ? &*found : nullptr;
}

} // namespace

TEST(BagCheck, TopicsSweepsAndJointsAreChoicesThatOpen) {
    const Scan scan = turned(80, 60);
    RosMessages messages = rosMessagesOf(scan, {.from = AngleFrom::Joint});
    const RosMessages rear = rosMessagesOf(turned(40, 50), {.from = AngleFrom::Nothing, .scanTopic = "/rear/scan", .frame = "rear"});
    const auto first = static_cast<std::uint32_t>(messages.topics.size());
    messages.topics.insert(messages.topics.end(), rear.topics.begin(), rear.topics.end());
    for (const auto& message : rear.messages) messages.message(message.topic + first, message.ns, message.bytes);
    const Bag bag = bagOf(messages);
    const auto guessed = opened(bag);
    ASSERT_TRUE(guessed) << guessed.error().sentence();
    const auto points = bagCheck(bag.listing, *guessed, {});
    ASSERT_EQ(points.size(), 3U);
    const OpeningPoint* topic = named(points, "Topic");
    ASSERT_TRUE(topic != nullptr);
    EXPECT_EQ(topic->taken.text(), "/robot/scan: lines of 60 beams; messages: 80, per second: 25");
    EXPECT_EQ(topic->source, OpeningPoint::Source::Guessed);
    ASSERT_EQ(topic->others.size(), 1U);
    EXPECT_EQ(topic->others[0].words.text(), "/rear/scan: lines of 50 beams; messages: 40, per second: 25");
    const auto other = opened(bag, topic->others[0].options);
    ASSERT_TRUE(other) << other.error().sentence();
    EXPECT_EQ(other->beams(), 50);
    const OpeningPoint* sweep = named(points, "Sweep");
    ASSERT_TRUE(sweep != nullptr);
    ASSERT_EQ(sweep->others.size(), 1U) << sweep->taken.text();
    const auto second = opened(bag, sweep->others[0].options);
    ASSERT_TRUE(second) << second.error().sentence();
    EXPECT_NE(second->rangeMm, guessed->rangeMm);
    const OpeningPoint* angle = named(points, "Angle of each line");
    ASSERT_TRUE(angle != nullptr);
    EXPECT_EQ(angle->taken.text(), "from the joint arm/tilt");
    ASSERT_EQ(angle->others.size(), 1U);
    EXPECT_EQ(angle->others[0].options.joint, "wheel");
    const auto rest = openingCheck(*guessed, {});
    const OpeningPoint* mounting = named(rest, "Mounting");
    ASSERT_TRUE(mounting != nullptr);
    EXPECT_EQ(mounting->source, OpeningPoint::Source::Assumed) << "a joint does not say the axis";
}

TEST(BagCheck, WhatWasSaidIsNotAGuess) {
    const Bag bag = bagOf(rosMessagesOf(boxesScan(40, 60, 3, 0.0), {.from = AngleFrom::Joint}));
    ReadingOptions options;
    options.topic = "/robot/scan";
    options.joint = "arm/tilt";
    const auto scan = opened(bag, options);
    ASSERT_TRUE(scan) << scan.error().sentence();
    const auto points = bagCheck(bag.listing, *scan, options);
    EXPECT_FALSE(looksGuessed(points));
    const OpeningPoint* angle = named(points, "Angle of each line");
    ASSERT_TRUE(angle != nullptr);
    ASSERT_EQ(angle->others.size(), 2U); // what is found, and the other joint
    EXPECT_TRUE(angle->others[0].options.joint.empty());
}
