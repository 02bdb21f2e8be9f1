// A robot's scanner that sends whole clouds over a bridge, live: each message is a scan, the same as a bag's.
#include "app/lab/robots/bridge.h"
#include "core/files/live_feed/live_health.h"
#include "core/files/open_save/open_scan.h"
#include "core/robots/live/robot_source.h"
#include "tests/support/live_session.h"
#include "tests/support/ros_clouds.h"
#include "tests/support/run_program.h"

#include <gtest/gtest.h>

using namespace edgescan;
using namespace edgescan::files;
using namespace edgescan::robots;
using namespace edgescan::test;

namespace {

constexpr int kCloudLines = 60, kCloudBeams = 50;

Scan scanOfRobot() {
    Scan scan = countingScan(kCloudLines, kCloudBeams);
    auto& polar = std::get<PolarGeometry>(scan.geometry);
    polar.axis = Axis::Sweep;
    for (int j = 0; j < kCloudBeams; ++j) polar.beamDeg[static_cast<std::size_t>(j)] = 70.0 + 0.5 * j;
    for (int i = 0; i < kCloudLines; ++i) polar.lineDeg[static_cast<std::size_t>(i)] = -3.0 + 0.3 * i;
    return scan;
}

scanner::EmulatedScannerSettings clouds(double perSecond) {
    scanner::EmulatedScannerSettings settings;
    settings.linesPerSecond = perSecond;
    return settings;
}

std::unique_ptr<robots::EmulatedBridge> cloudBridgeOf(const Scan& scan, const scanner::EmulatedScannerSettings& settings) {
    auto bridge = robots::serveBridge(robots::bridgeCloudOf(scan), settings);
    EXPECT_TRUE(bridge) << bridge.error().sentence();
    return std::move(*bridge);
}

scanner::ConnectionSettings settingsAt(const robots::EmulatedBridge& bridge, const scanner::ScannerTimeouts& timeouts = patient()) {
    scanner::ConnectionSettings settings;
    settings.host = "127.0.0.1";
    settings.port = bridge.port();
    settings.timeouts = timeouts;
    settings.bridge = true;
    return settings;
}

void expectSameCells(const Scan& a, const Scan& b) {
    ASSERT_EQ(a.lines(), b.lines());
    ASSERT_EQ(a.beams(), b.beams());
    EXPECT_EQ(a.state.cells, b.state.cells);
    EXPECT_EQ(a.rangeMm.cells, b.rangeMm.cells);
    EXPECT_EQ(a.attached.size(), b.attached.size());
}

TEST(BridgeCloud, EachMessageIsAScanAndTheRecordingOpensAsTheSame) {
    const Scan scan = scanOfRobot();
    const auto bridge = cloudBridgeOf(scan, clouds(50));
    const TemporaryFolder folder;
    LiveFeed feed(settingsAt(*bridge), scanner::assumedSweep(), [] {}, {.lines = 5});
    ASSERT_TRUE(feed.startRecording(folder / "robot.mcap"));
    ASSERT_TRUE(waitUntil([&] { return feed.status().linesAfter > 0 && feed.snapshot(); })) << feed.status().connection.sentence;
    EXPECT_EQ(feed.status().connection.phase, scanner::ConnectionPhase::Live);
    EXPECT_TRUE(feed.sweep().progress.growing) << "more clouds come";
    feed.stop();
    const scanner::SweepState last = feed.sweep();
    EXPECT_FALSE(last.progress.growing);
    EXPECT_EQ(last.progress.text(), "60/60 lines");
    EXPECT_EQ(feed.status().lines, 5);
    EXPECT_EQ(feed.status().undecodable, 0);
    EXPECT_FALSE(feed.status().settings.axisAssumed || feed.status().settings.stepAssumed) << "the points say it";
    EXPECT_EQ(feed.status().settings.axis, Axis::Sweep);
    EXPECT_EQ(feed.status().sweep.account.telegrams, 5);
    EXPECT_TRUE(feed.status().sweep.account.addsUp());
    const auto recorded = feed.stopRecording();
    ASSERT_TRUE(recorded);
    EXPECT_EQ(recorded->messages, 5U);
    const auto opened = openScan(folder / "robot.mcap", {});
    ASSERT_TRUE(opened) << opened.error().sentence();
    expectSameCells(*last.scan, *opened);
    EXPECT_EQ(last.scan->cells(), scan.cells());
    EXPECT_EQ(countCells(*last.scan), countCells(scan));
    EXPECT_EQ(bridge->statistics().subscribed, std::set<std::string>{"/points"}) << "a cloud needs no angles";
    EXPECT_EQ(bridge->statistics().asked.size(), 1U);
}

TEST(BridgeCloud, CloudsThatAreCutOffAreCountedAndABrokenConnectionComesBack) {
    scanner::EmulatedScannerSettings settings = clouds(50);
    settings.faults.corruptEvery = 2;
    settings.faults.dropEvery = 9;
    const auto bridge = cloudBridgeOf(scanOfRobot(), settings);
    LiveFeed feed(settingsAt(*bridge), scanner::assumedSweep(), [] {});
    ASSERT_TRUE(waitUntil([&] { return feed.status().undecodable > 2 && feed.status().statistics.reconnects > 0 && feed.snapshot(); }));
    EXPECT_FALSE(feed.status().whyUndecodable.empty());
    EXPECT_EQ(feed.snapshot()->lines(), kCloudLines);
    feed.stop();
    EXPECT_TRUE(feed.status().sweep.account.addsUp());
}

TEST(BridgeCloud, WhereNoMessageMakesAScanItIsSaidWhy) {
    scanner::EmulatedScannerSettings settings = clouds(50);
    settings.faults.corruptEvery = 1;
    const auto bridge = cloudBridgeOf(scanOfRobot(), settings);
    LiveFeed feed(settingsAt(*bridge), scanner::assumedSweep(), [] {});
    ASSERT_TRUE(waitUntil([&] { return feed.status().connection.problem.has_value(); }));
    const std::string sentence = feed.status().connection.sentence;
    EXPECT_NE(sentence.find("/points"), std::string::npos) << sentence;
    EXPECT_EQ(sentence.find('\n'), std::string::npos);
}

TEST(BridgeCloud, APictureThatGetsNoMoreCloudsIsStale) {
    scanner::EmulatedScannerSettings settings = clouds(50);
    settings.faults.stallEvery = 10;
    settings.faults.stallS = 600;
    const auto bridge = cloudBridgeOf(scanOfRobot(), settings);
    LiveFeed feed(settingsAt(*bridge), scanner::assumedSweep(), [] {});
    ASSERT_TRUE(waitUntil([&] { return feed.snapshot() && healthOf(feed.status()).liveness == Liveness::Live; }));
    ASSERT_TRUE(waitUntil([&] { return healthOf(feed.status()).liveness == Liveness::Stale; }));
}

RecordingMessagePtr messageOf(Bytes payload, std::int64_t ns) {
    return std::make_shared<const RecordingMessage>(RecordingMessage{RecordingTopic::Bridge, ns, std::move(payload)});
}

TEST(BridgeCloud, OfManyCloudsTheNewestIsShownWithItsRingsAndFirings) {
    const robots::RosTopic topic{"/points", "sensor_msgs/PointCloud2", std::string(robots::commonRosDefinition("sensor_msgs/PointCloud2"))};
    LiveCloud live([] {});
    Bytes last;
    for (int message = 0; message < 40; ++message) {
        std::vector<RosPoint> points;
        for (int firing = 0; firing < kFirings / 2 + message; ++firing) {
            for (int ring = 0; ring < kRings; ++ring) {
                if (!isMissing(ring, firing)) points.push_back(pointOf(ring, firing));
            }
        }
        last = cloudOf(points, 1, Wire::CdrLittle);
        live.receive(topic, messageOf(last, 1000 + message));
    }
    live.finish();
    const scanner::SweepState newest = live.newest();
    ASSERT_TRUE(newest.scan);
    EXPECT_EQ(newest.progress.newestNs, 1039);
    EXPECT_EQ(live.progress().account.telegrams, 40);
    EXPECT_EQ(live.unusable(), 0);
    RosMessages bag;
    bag.message(bag.topic("/points", topic.type, Wire::CdrLittle), kRosStartNs, last);
    const Bytes bytes = mcapOf(bag);
    const auto opened = readScanBytes(std::as_bytes(std::span(bytes)), ".mcap", {});
    ASSERT_TRUE(opened);
    expectSameCells(*newest.scan, *opened);
    EXPECT_EQ(std::max(opened->lines(), opened->beams()), kFirings / 2 + 39);
}

robots::BridgeChannelPtr cloudChannel(const char* topic, const char* type) {
    return std::make_shared<const robots::BridgeChannel>(robots::BridgeChannel{1, topic, "cdr", type, {}, {}});
}

TEST(BridgeCloud, ATopicOfCloudsIsTakenByNameOrWhereThereIsNoneOfLines) {
    const auto points = cloudChannel("/ouster/points", "sensor_msgs/msg/PointCloud2"),
               scan = cloudChannel("/scan", "sensor_msgs/msg/LaserScan"), tf = cloudChannel("/tf", "tf2_msgs/msg/TFMessage");
    const auto alone = chooseTopics({points, tf}, "", "robot:8765");
    ASSERT_TRUE(alone);
    EXPECT_EQ(alone->lines, points);
    EXPECT_EQ(alone->channels.size(), 1U);
    EXPECT_TRUE(alone->note.empty());
    const auto lines = chooseTopics({points, scan, tf}, "", "robot:8765");
    ASSERT_TRUE(lines);
    EXPECT_EQ(lines->lines, scan);
    EXPECT_NE(lines->note.find("/ouster/points"), std::string::npos);
    EXPECT_EQ(chooseTopics({points, scan, tf}, "/ouster/points", "robot:8765")->lines, points);
}

} // namespace
