// A robot's bridge, live: the scan grows like a scanner's, nothing but subscriptions is sent, faults are sentences.
#include "app/lab/robots/bridge.h"
#include "core/files/live_feed/live_feed.h"
#include "core/files/open_save/open_scan.h"
#include "core/robots/live/robot_source.h"
#include "tests/support/folders.h"
#include "tests/support/live_session.h"
#include "tests/support/python_peer.h"
#include "tests/support/run_program.h"

#include <boost/asio.hpp>

#include <gtest/gtest.h>

using namespace edgescan;
using namespace edgescan::files;
using namespace edgescan::robots;
using namespace edgescan::test;

namespace {

constexpr int kBridgeLines = 80, kBridgeBeams = 30;

Scan turnedScan(Axis axis) {
    Scan scan = countingScan(kBridgeLines, kBridgeBeams);
    auto& polar = std::get<PolarGeometry>(scan.geometry);
    polar.axis = axis;
    const double first = 75.0; // a spin is about a beam near the middle of the fan, a sweep about one across it
    for (int j = 0; j < kBridgeBeams; ++j) polar.beamDeg[static_cast<std::size_t>(j)] = first + 0.5 * j;
    for (int i = 0; i < kBridgeLines; ++i) polar.lineDeg[static_cast<std::size_t>(i)] = -3.0 + 0.3 * i;
    return scan;
}

std::unique_ptr<robots::EmulatedBridge> bridgeOf(const Scan& scan, const scanner::EmulatedScannerSettings& settings) {
    auto sweep = robots::bridgeSweepOf(scan);
    EXPECT_TRUE(sweep);
    auto bridge = robots::serveBridge(std::move(*sweep), settings);
    EXPECT_TRUE(bridge) << bridge.error().sentence();
    return std::move(*bridge);
}

scanner::ConnectionSettings settingsAt(std::uint16_t port, const scanner::ScannerTimeouts& timeouts = patient()) {
    scanner::ConnectionSettings settings;
    settings.host = "127.0.0.1";
    settings.port = port;
    settings.timeouts = timeouts;
    settings.bridge = true;
    return settings;
}

scanner::EmulatedScannerSettings once(double linesPerSecond = 400) {
    scanner::EmulatedScannerSettings settings;
    settings.linesPerSecond = linesPerSecond;
    settings.atEnd = scanner::AtEnd::Stop;
    return settings;
}

void expectSame(const Scan& opened, const Scan& scan, int lines = kBridgeLines) {
    ASSERT_EQ(opened.lines(), lines);
    ASSERT_EQ(opened.beams(), scan.beams());
    for (int i = 0; i < lines; ++i) {
        for (int j = 0; j < scan.beams(); ++j) {
            ASSERT_EQ(opened.state.at(i, j), scan.state.at(i, j)) << i << ' ' << j;
            if (scan.state.at(i, j) == CellState::Valid) {
                ASSERT_EQ(opened.rangeMm.at(i, j), scan.rangeMm.at(i, j)) << i << ' ' << j;
            }
        }
    }
}

void expectSameAngles(const Scan& opened, const Scan& scan) {
    const auto& found = std::get<PolarGeometry>(opened.geometry);
    const auto& given = std::get<PolarGeometry>(scan.geometry);
    EXPECT_EQ(found.axis, given.axis);
    const double sign = found.lineDirection;
    for (std::size_t i = 0; i < found.lineDeg.size(); ++i)
        ASSERT_NEAR(sign * (found.lineDeg[i] - found.lineDeg[0]), given.lineDeg[i] - given.lineDeg[0], 1e-6) << i;
    for (std::size_t j = 0; j < found.beamDeg.size(); ++j) ASSERT_NEAR(found.beamDeg[j], given.beamDeg[j], 1e-4) << j;
}

/// An independent bridge in Python.
class MockBridge {
public:
    explicit MockBridge(const std::string& fault = {}) : port_(freePort()), process_(words(fault)) {}
    [[nodiscard]] std::uint16_t port() const { return port_; }

private:
    static std::uint16_t freePort() {
        boost::asio::io_context context;
        const boost::asio::ip::tcp::acceptor acceptor(context, {boost::asio::ip::address_v4::loopback(), 0});
        return acceptor.local_endpoint().port();
    }
    [[nodiscard]] std::vector<std::string> words(const std::string& fault) const {
        std::vector<std::string> all{"python3", (ownData() / "bridge/mock_foxglove_bridge.py").string(), std::to_string(port_)};
        if (!fault.empty()) all.push_back(fault);
        return all;
    }
    std::uint16_t port_;
    Process process_;
};

TEST(Bridge, GrowsLikeTheScanThatIsSent) {
    for (const Axis axis : {Axis::Spin, Axis::Sweep}) {
        const Scan scan = turnedScan(axis);
        const auto bridge = bridgeOf(scan, once());
        const TemporaryFolder folder;
        LiveFeed feed(settingsAt(bridge->port()), scanner::assumedSweep(), [] {});
        ASSERT_TRUE(feed.startRecording(folder / "robot.mcap"));
        ASSERT_TRUE(waitUntil([&] { return feed.status().lines >= kBridgeLines; }))
            << feed.status().connection.sentence << feed.status().lines;
        EXPECT_EQ(feed.status().connection.phase, scanner::ConnectionPhase::Live);
        const auto live = feed.snapshot();
        ASSERT_TRUE(live);
        expectSame(*live, scan);
        expectSameAngles(*live, scan);
        feed.stop();
        ASSERT_TRUE(feed.stopRecording());
        // What came is in the recording as it came: it opens as a bag.
        const auto opened = openScan(folder / "robot.mcap", {});
        ASSERT_TRUE(opened) << opened.error().sentence();
        expectSame(*opened, scan);
        expectSameAngles(*opened, scan);
        EXPECT_EQ(opened->format, "ROS 2 bag (MCAP)");
        // It is played line by line, too.
        const auto recording = Recording::open(folder / "robot.mcap");
        ASSERT_TRUE(recording) << recording.error().sentence();
        Replay replay(*recording);
        ASSERT_EQ(replay.lines(), kBridgeLines);
        for (const int line : {kBridgeLines, 40, kBridgeLines}) {
            replay.seek(line);
            ASSERT_TRUE(replay.snapshot()) << line;
            expectSame(*replay.snapshot(), scan, line);
        }
        expectSameAngles(*replay.snapshot(), scan);
    }
}

TEST(Bridge, IsOnlyAskedForTheTopicsOfTheLaser) {
    const auto bridge = bridgeOf(turnedScan(Axis::Sweep), once());
    {
        LiveFeed feed(settingsAt(bridge->port()), scanner::assumedSweep(), [] {});
        ASSERT_TRUE(waitUntil([&] { return feed.status().lines > 20; })) << feed.status().connection.sentence;
        bridge->dropConnections();
        ASSERT_TRUE(waitUntil([&] { return feed.status().statistics.reconnects > 0 && feed.status().lines > 40; }));
    }
    const auto statistics = bridge->statistics();
    EXPECT_EQ(statistics.subscribed, (std::set<std::string>{"/scan", "/tf", "/tf_static"}));
    ASSERT_EQ(statistics.asked.size(), 1U) << statistics.asked.begin()->first;
    EXPECT_EQ(statistics.asked.begin()->first, "subscribe");
}

TEST(Bridge, LinesThatAreLostOrCutOffAreCounted) {
    scanner::EmulatedScannerSettings settings = once(200);
    settings.faults.loseEvery = 16;
    settings.faults.corruptEvery = 25;
    const Scan scan = turnedScan(Axis::Sweep);
    const auto bridge = bridgeOf(scan, settings);
    LiveFeed feed(settingsAt(bridge->port()), scanner::assumedSweep(), [] {});
    const int lost = kBridgeLines / 16, cut = kBridgeLines / 25;
    ASSERT_TRUE(waitUntil([&] { return feed.status().sweep.lines >= kBridgeLines - 1; })) << feed.status().sweep.lines;
    const LiveStatus status = feed.status();
    EXPECT_EQ(status.undecodable, cut);
    EXPECT_FALSE(status.whyUndecodable.empty());
    EXPECT_EQ(static_cast<int>(status.sweep.lost.size()), lost - 1 + cut) << "the last line is not known to be lost";
    for (const int row : status.sweep.lost) EXPECT_TRUE((row + 1) % 16 == 0 || (row + 1) % 25 == 0) << row;
}

TEST(Bridge, ALineTwiceIsLeftOutAndASweepBackIsASweepOfItsOwn) {
    scanner::EmulatedScannerSettings settings = once(400);
    settings.atEnd = scanner::AtEnd::Reverse;
    settings.faults.duplicateEvery = 20;
    const auto bridge = bridgeOf(turnedScan(Axis::Sweep), settings);
    LiveFeed feed(settingsAt(bridge->port()), scanner::assumedSweep(), [] {});
    ASSERT_TRUE(waitUntil([&] { return feed.status().sweep.number >= 2; }));
    const auto finished = feed.popFinished();
    ASSERT_GE(finished.size(), 2U);
    EXPECT_NEAR(finished.front().scan->lines(), kBridgeLines, 1);
    EXPECT_TRUE(finished.front().progress.lost.empty());
    EXPECT_GE(feed.status().sweep.duplicates, 4);
    EXPECT_EQ(feed.status().undecodable, 0);
}

TEST(Bridge, ReconnectsAndMissesOnlyWhatWasSentMeanwhile) {
    const Scan scan = turnedScan(Axis::Sweep);
    const auto bridge = bridgeOf(scan, once(100));
    LiveFeed feed(settingsAt(bridge->port()), scanner::assumedSweep(), [] {});
    ASSERT_TRUE(waitUntil([&] { return feed.status().lines > 30; }));
    bridge->dropConnections();
    ASSERT_TRUE(waitUntil([&] { return feed.status().statistics.reconnects == 1 && feed.status().sweep.lines >= kBridgeLines - 1; }));
    EXPECT_LE(feed.status().sweep.lost.size(), 12U);
    EXPECT_EQ(feed.status().connection.phase, scanner::ConnectionPhase::Live);
}

TEST(Bridge, APeerWrittenByOthersGivesTheSameScan) {
    if (!pythonIsThere()) GTEST_SKIP() << "needs python3";
    const MockBridge bridge;
    LiveFeed feed(settingsAt(bridge.port()), scanner::assumedSweep(), [] {});
    ASSERT_TRUE(waitUntil([&] { return feed.status().lines >= kBridgeLines; })) << feed.status().connection.sentence << feed.status().lines;
    const auto live = feed.snapshot();
    ASSERT_TRUE(live);
    expectSame(*live, countingScan(kBridgeLines, kBridgeBeams));
    const auto& polar = std::get<PolarGeometry>(live->geometry);
    for (int i = 0; i < kBridgeLines; ++i)
        ASSERT_NEAR(std::abs(polar.lineDeg[static_cast<std::size_t>(i)] - polar.lineDeg[0]), 0.3 * i, 1e-6) << i;
}

TEST(Bridge, WhatIsNoBridgeIsNamedInOneSentence) {
    if (!pythonIsThere()) GTEST_SKIP() << "needs python3";
    const std::vector<std::pair<std::string, std::string>> faults{{"http", "is not a Foxglove bridge"},
                                                                  {"garbage", "is not the Foxglove WebSocket protocol"},
                                                                  {"huge", "more than 64 MB"},
                                                                  {"silent", "offers no topics"}};
    for (const auto& [fault, sentence] : faults) {
        const MockBridge bridge(fault);
        LiveFeed feed(settingsAt(bridge.port(), hasty()), scanner::assumedSweep(), [] {});
        const auto said = [&] {
            const auto problem = feed.status().connection.problem;
            return problem ? problem->sentence() : std::string();
        };
        EXPECT_TRUE(waitUntil([&] { return said().find(sentence) != std::string::npos; })) << fault << ": " << said();
        EXPECT_EQ(said().find('\n'), std::string::npos);
    }
}

robots::BridgeChannelPtr channel(const char* topic, const char* type) {
    return std::make_shared<const robots::BridgeChannel>(robots::BridgeChannel{1, topic, "cdr", type, {}, {}});
}

TEST(Bridge, TheLaserIsChosenAndAGuessIsNamed) {
    const std::vector<robots::BridgeChannelPtr> offered{
        channel("/b/scan", "sensor_msgs/msg/LaserScan"), channel("/camera", "sensor_msgs/msg/Image"),
        channel("/a/scan", "sensor_msgs/msg/LaserScan"), channel("/tf", "tf2_msgs/msg/TFMessage"),
        channel("/joints", "sensor_msgs/msg/JointState")};
    const auto guess = chooseTopics(offered, "", "robot:8765");
    ASSERT_TRUE(guess);
    EXPECT_EQ(guess->lines->topic, "/a/scan");
    EXPECT_EQ(guess->channels.size(), 3U);
    EXPECT_NE(guess->note.find("/b/scan"), std::string::npos);
    std::vector<robots::BridgeChannelPtr> more = offered;
    more.push_back(channel("/robot/tilt_scan", "sensor_msgs/msg/LaserScan"));
    EXPECT_EQ(chooseTopics(more, "", "robot:8765")->lines->topic, "/robot/tilt_scan") << "its name says that it is turned";
    const auto named = chooseTopics(offered, "/b/scan", "robot:8765");
    ASSERT_TRUE(named);
    EXPECT_EQ(named->lines->topic, "/b/scan");
    EXPECT_TRUE(named->note.empty());
    EXPECT_NE(chooseTopics(offered, "/camera", "robot:8765").error().sentence().find("/a/scan"), std::string::npos);
    EXPECT_NE(chooseTopics({offered[1]}, "", "robot:8765").error().sentence().find("/camera"), std::string::npos);
}

} // namespace
