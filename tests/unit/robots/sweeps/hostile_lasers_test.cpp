// Bags and bridges with transforms without end, angles that no laser has, damaged messages, and recorders that were killed.
#include "core/files/open_save/open_scan.h"
#include "core/robots/bridge/protocol.h"
#include "core/robots/sweeps/bag_folder.h"
#include "core/robots/sweeps/frames.h"
#include "core/robots/sweeps/live_laser.h"
#include "tests/support/ros_sweeps.h"
#include "tests/support/run_program.h"
#include "tests/support/scans.h"

#include <gtest/gtest.h>

#include <ctime>
#include <fstream>

using namespace edgescan;
using namespace edgescan::robots;
using namespace edgescan::test;

namespace {

constexpr int kFrames = 20'000;

Result<Scan> scanOf(const Bytes& bytes, const ReadingOptions& options = {}) {
    return files::readScanBytes(std::as_bytes(std::span(bytes)), ".bag", options);
}

bool warns(const std::vector<std::string>& warnings, std::string_view words) {
    return std::ranges::any_of(warnings, [&](const std::string& w) { return w.find(words) != std::string::npos; });
}

Scan boxes() {
    Scan scan = boxesScan(20, 40, 3, 0.05);
    auto& polar = std::get<PolarGeometry>(scan.geometry);
    polar.axis = Axis::Sweep;
    for (int i = 0; i < scan.lines(); ++i) polar.lineDeg[static_cast<std::size_t>(i)] = -20 + 3.0 * i;
    return scan;
}

/// mast in f0, f0 in f1, ...
Bytes chainMessage(Wire wire) {
    RosWriter message(wire);
    message.count(kFrames);
    for (int n = 0; n < kFrames; ++n) {
        const std::string child = n == 0 ? "mast" : "f" + std::to_string(n - 1);
        message.header(kRosStartNs, "f" + std::to_string(n)).text(child).put(0.0).put(0.0).put(0.0).put(0.0).put(0.0).put(0.0).put(1.0);
    }
    return message.bytes();
}

/// Writes a number of 4 bytes into each line's message: angle_min is the first behind the header.
RosMessages withNumber(RosMessages all, std::size_t field, float value) {
    for (RosMessages::Message& message : all.messages) {
        if (message.topic == 0) std::memcpy(message.bytes.data() + 16 + RosSweep{}.frame.size() + 4 * field, &value, 4);
    }
    return all;
}

} // namespace

TEST(HostileFrames, AChainOfTwentyThousandIsGoneOnce) {
    const auto chained = [](robots::FrameTree& tree, int frames) { // seconds of the processor
        const std::clock_t start = std::clock();
        for (int n = 0; n < frames; ++n) tree.add({"f" + std::to_string(n), "f" + std::to_string(n + 1), {}});
        tree.finish();
        return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    };
    robots::FrameTree tree, shorter;
    const double few = chained(shorter, kFrames / 10);
    EXPECT_LT(chained(tree, kFrames), 40 * few + 0.1) << "ten times as many cost ten times as much, not a hundred times";
    EXPECT_TRUE(warns(tree.warnings(), "a chain of more than 1000 frames"));
    EXPECT_EQ(tree.chain("f0").size(), 1000U);
    RosMessages messages = rosMessagesOf(boxes());
    messages.message(messages.topic("/tf_static", "tf2_msgs/TFMessage", Wire::Ros1), kRosStartNs, chainMessage(Wire::Ros1));
    const auto scan = scanOf(bag1Of(messages));
    ASSERT_TRUE(scan) << scan.error().sentence();
    EXPECT_EQ(scan->lines(), 20);
    EXPECT_TRUE(warns(scan->warnings, "a chain of more than 1000 frames"));
}

TEST(HostileFrames, LoopsAreNamedAndBranchesAreNone) {
    robots::FrameTree loop;
    for (const auto& [child, parent] : {std::pair("a", "b"), {"b", "c"}, {"c", "a"}, {"d", "c"}}) loop.add({child, parent, {}});
    loop.finish();
    EXPECT_TRUE(warns(loop.warnings(), "form a loop at the frame a"));
    robots::FrameTree branches;
    for (const auto& [child, parent] : {std::pair("a", "b"), {"b", "root"}, {"c", "b"}, {"d", "a"}, {"z", "root"}})
        branches.add({child, parent, {}});
    branches.finish();
    EXPECT_TRUE(branches.warnings().empty());
}

TEST(HostileFrames, LiveTheyHoldNothingUp) {
    const RosSweep sent{.wire = Wire::CdrLittle};
    const RosMessages messages = rosMessagesOf(boxes(), sent);
    robots::LiveLaser laser({}, "");
    scanner::SweepAssembler to{{}};
    const auto topicOf = [&](std::uint32_t n) {
        return RosTopic{messages.topics[n].name, messages.topics[n].type, messages.topics[n].definition, RosEncoding::Cdr, false};
    };
    laser.receive(topicOf(1), chainMessage(Wire::CdrLittle), to);
    int lines = 0;
    for (const RosMessages::Message& message : messages.messages) lines += laser.receive(topicOf(message.topic), message.bytes, to);
    EXPECT_GT(lines, 0);
}

// 80 m and 10 mm are range_max and range_min of rosLaserScan().
class LimitOfALiveLaser : public testing::TestWithParam<float> {};
INSTANTIATE_TEST_SUITE_P(Both, LimitOfALiveLaser, testing::Values(80000.0F, 10.0F));

TEST_P(LimitOfALiveLaser, WasNotMeasuredWhereItRepeats) {
    Scan scan = boxes();
    constexpr int kVoid = 12;
    for (int line = 0; line < scan.lines(); ++line) {
        for (int beam = 3; beam < 3 + kVoid; ++beam) {
            scan.rangeMm.at(line, beam) = GetParam();
            scan.state.at(line, beam) = CellState::Valid;
        }
    }
    const RosMessages messages = rosMessagesOf(scan, {.wire = Wire::CdrLittle});
    for (const bool keep : {false, true}) {
        robots::LiveLaser laser({}, "", keep);
        scanner::SweepAssembler to{{}};
        for (const RosMessages::Message& message : messages.messages) {
            const auto& topic = messages.topics[message.topic];
            laser.receive({topic.name, topic.type, topic.definition, RosEncoding::Cdr, false}, message.bytes, to);
        }
        to.finish();
        EXPECT_EQ(laser.noReturns(), keep ? 0 : scan.lines() * kVoid);
        const auto found = to.snapshot();
        ASSERT_TRUE(found);
        EXPECT_EQ(std::ranges::count(found->rangeMm.cells, GetParam()) > 0, keep);
        EXPECT_GT(found->lines(), 0);
    }
}

TEST(LiveLasers, ALineThatARelaySendsWithAnotherStampIsARepeat) {
    const RosMessages messages = rosMessagesOf(boxes(), {.wire = Wire::CdrLittle}),
                      relayed = rosMessagesOf(boxes(), {.jitterNs = {2'000'000}, .wire = Wire::CdrLittle});
    robots::LiveLaser laser({}, "");
    scanner::SweepAssembler to{{}};
    std::int64_t lines = 0;
    for (std::size_t n = 0; n < messages.messages.size(); ++n) {
        const auto& topic = messages.topics[messages.messages[n].topic];
        const RosTopic of{topic.name, topic.type, topic.definition, RosEncoding::Cdr, false};
        laser.receive(of, messages.messages[n].bytes, to);
        if (topic.type.find("LaserScan") == std::string::npos) continue;
        ++lines;
        laser.receive(of, relayed.messages[n].bytes, to);
    }
    EXPECT_EQ(laser.repeated(), lines - 1); // the first one shows no period
}

TEST(HostileFrames, PosesWithoutEndAreLimitedLive) {
    robots::FrameTree tree(100);
    for (int n = 0; n < 1000; ++n) tree.add({"laser", "base", {n, Eigen::Quaterniond::Identity(), Eigen::Vector3d::Zero()}});
    EXPECT_EQ(tree.link("laser")->poses.size(), 100U);
    tree.forgetBefore(90);
    tree.add({"laser", "base", {1000, Eigen::Quaterniond::Identity(), Eigen::Vector3d::Zero()}});
    EXPECT_EQ(tree.link("laser")->poses.size(), 11U);
}

TEST(HostileBridge, AListOfTopicsWithoutEndIsRefusedBeforeItIsParsed) {
    std::string json = R"({"op":"advertise","channels":[{})";
    while (json.size() < (5U << 20U)) json += ",{}";
    const auto text = robots::bridgeText(json + "]}", "ws://robot");
    ASSERT_FALSE(text);
    EXPECT_NE(text.error().what.find("more than 4 MB"), std::string::npos) << text.error().sentence();
}

TEST(HostileLasers, AnglesThatNoLaserHasAreNeverReplaced) {
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    constexpr std::size_t kAngleMin = 0, kIncrement = 2;
    struct {
        std::size_t field;
        float value;
        const char* words;
    } const cases[]{{kAngleMin, nan, "angle_min"},        {kAngleMin, inf, "angle_min"},         {kAngleMin, -inf, "angle_min"},
                    {kAngleMin, 1e30F, "angle_min"},      {kAngleMin, 100.0F, "angle_min"},      {kIncrement, nan, "angle_increment"},
                    {kIncrement, inf, "angle_increment"}, {kIncrement, 0.0F, "angle_increment"}, {kIncrement, 2.3F, "angle_increment"}};
    for (const auto& [field, value, words] : cases) {
        const auto scan = scanOf(bag1Of(withNumber(rosMessagesOf(boxes()), field, value)));
        ASSERT_FALSE(scan) << field << ' ' << value;
        EXPECT_NE(scan.error().what.find(words), std::string::npos) << scan.error().sentence();
    }
}

TEST(HostileLasers, WhatContradictsItselfIsTold) {
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    constexpr std::size_t kAngleMax = 1, kTimeIncrement = 3;
    for (const float value : {nan, inf, -inf, 1e30F}) {
        const auto scan = scanOf(bag1Of(withNumber(rosMessagesOf(boxes()), kTimeIncrement, value)));
        ASSERT_TRUE(scan) << scan.error().sentence();
        EXPECT_TRUE(warns(scan->warnings, "20 messages have a time_increment")) << value;
    }
    const auto scan = scanOf(bag1Of(withNumber(rosMessagesOf(boxes()), kAngleMax, -3.0F)));
    ASSERT_TRUE(scan) << scan.error().sentence();
    EXPECT_TRUE(warns(scan->warnings, "angle_max"));
    EXPECT_FALSE(warns(scanOf(bag1Of(rosMessagesOf(boxes())))->warnings, "angle_max"));
}

TEST(HostileLasers, AScanWithoutAnyRangeIsTold) {
    constexpr std::size_t kRangeMin = 5;
    const auto scan = scanOf(bag1Of(withNumber(rosMessagesOf(boxes()), kRangeMin, 70.0F)));
    ASSERT_TRUE(scan) << scan.error().sentence();
    EXPECT_TRUE(warns(scan->warnings, "No cell of this scan has a range"));
}

TEST(HostileLasers, DamagedMessagesHaveTheirNumber) {
    for (const AngleFrom from : {AngleFrom::Transform, AngleFrom::Joint}) {
        RosMessages messages = rosMessagesOf(boxes(), {.from = from});
        int cut = 0;
        for (RosMessages::Message& message : messages.messages) {
            if (message.topic == 1 && ++cut % 10 == 0) message.bytes.resize(message.bytes.size() / 2);
        }
        const auto scan = scanOf(bag1Of(messages));
        ASSERT_TRUE(scan) << scan.error().sentence();
        EXPECT_TRUE(
            warns(scan->warnings, std::to_string(cut / 10) + " messages of " + (from == AngleFrom::Joint ? "joints" : "transforms")));
    }
}

TEST(HostileLasers, ThousandsOfTopicsAreNotAllTried) {
    RosMessages messages;
    const auto tf = messages.topic("/tf", "tf2_msgs/TFMessage", Wire::Ros1);
    for (int n = 0; n < 2000; ++n) messages.message(tf, kRosStartNs + n, rosTransform(0, kRosStartNs + n, {}));
    const Scan scan = boxes();
    const auto& polar = std::get<PolarGeometry>(scan.geometry);
    for (int n = 0; n < 2000; ++n) {
        const auto topic = messages.topic("/scan" + std::to_string(n), "sensor_msgs/LaserScan", Wire::Ros1);
        messages.message(topic, kRosStartNs + n, rosLaserScan(scan, polar.beamDeg, 0, {}));
    }
    EXPECT_FALSE(scanOf(bag1Of(messages)));
}

TEST(HostileLasers, TheWishToStopIsHeardAtEveryQuestion) {
    const Bytes bag = bag1Of(rosMessagesOf(boxes()));
    int questions = 0;
    ReadingOptions options;
    options.progress = [&](const char*, double) { return ++questions > 0; };
    ASSERT_TRUE(scanOf(bag, options));
    EXPECT_GT(questions, 20);
    for (int last = 1; last < questions; ++last) {
        int asked = 0;
        options.progress = [&](const char*, double) { return ++asked < last; };
        const auto scan = scanOf(bag, options);
        ASSERT_FALSE(scan) << last;
        EXPECT_EQ(scan.error().what, "cancelled");
        EXPECT_LE(asked, last + 3) << last; // it does not go on with something else
    }
}

TEST(BagFolder, MetadataThatNamesOnlyFilesThatAreGoneIsTold) {
    const TemporaryFolder folder;
    std::ofstream(folder / "metadata.yaml") << "rosbag2_bagfile_information:\n  relative_file_paths:\n    - bell_0.db3\n    - bell_1.db3\n";
    const auto scan = files::openScan(folder.path());
    ASSERT_FALSE(scan);
    EXPECT_NE(scan.error().what.find("bell_0.db3 and 1 more"), std::string::npos) << scan.error().sentence();
}

TEST(BagFolder, APartThatMetadataDoesNotNameIsTold) {
    const TemporaryFolder folder;
    std::ofstream(folder / "metadata.yaml") << "rosbag2_bagfile_information:\n  relative_file_paths:\n    - bell_0.mcap\n";
    for (const char* name : {"bell_0.mcap", "bell_1.mcap", "other.mcap"}) std::ofstream(folder / name) << "x";
    const auto files = filesOfBag(folder.path());
    ASSERT_TRUE(files);
    EXPECT_EQ(files->unnamed, std::vector<std::string>{"bell_1.mcap"});
}

#ifdef EDGESCAN_TESTS_SQLITE
TEST(KilledRecorder, TheLogBesideTheDatabaseIsPartOfTheScan) {
    const TemporaryFolder folder;
    const Scan scan = boxes();
    RosMessages first = rosMessagesOf(scan, {.wire = Wire::CdrLittle}), rest = first;
    std::ranges::stable_sort(first.messages, {}, &RosMessages::Message::ns);
    const auto half = static_cast<std::ptrdiff_t>(first.messages.size() / 2);
    rest.messages.assign(first.messages.begin() + half, first.messages.end());
    first.messages.resize(static_cast<std::size_t>(half));
    const std::string live = (folder / "live.db3").string(), killed = (folder / "killed.db3").string();
    const Bytes bag = databaseOf(first);
    std::ofstream(live, std::ios::binary).write(reinterpret_cast<const char*>(bag.data()), static_cast<std::streamsize>(bag.size()));
    sqlite3* base = nullptr;
    sqlite3_open(live.c_str(), &base);
    sqlite3_exec(base, "PRAGMA journal_mode=WAL; PRAGMA wal_autocheckpoint=0", nullptr, nullptr, nullptr);
    for (const RosMessages::Message& message : rest.messages) {
        sqlite3_stmt* row = nullptr;
        sqlite3_prepare_v2(base, "INSERT INTO messages(topic_id, timestamp, data) VALUES(?, ?, ?)", -1, &row, nullptr);
        sqlite3_bind_int64(row, 1, message.topic + 1);
        sqlite3_bind_int64(row, 2, message.ns);
        sqlite3_bind_blob(row, 3, message.bytes.data(), static_cast<int>(message.bytes.size()), SQLITE_TRANSIENT);
        EXPECT_EQ(sqlite3_step(row), SQLITE_DONE);
        sqlite3_finalize(row);
    }
    std::filesystem::copy_file(live, killed);
    std::filesystem::copy_file(live + "-wal", killed + "-wal");
    sqlite3_close(base);
    const std::string before = fileText(killed), log = fileText(killed + "-wal");
    std::filesystem::create_symlink(killed, folder / "link.db3"); // the log is in the folder of the file itself
    for (const char* name : {"killed.db3", "link.db3"}) {
        const auto read = files::openScan(folder / name);
        ASSERT_TRUE(read) << read.error().sentence();
        EXPECT_EQ(read->lines(), scan.lines());
        EXPECT_EQ(read->rangeMm, scan.rangeMm);
        EXPECT_TRUE(warns(read->warnings, "killed.db3-wal"));
    }
    EXPECT_EQ(fileText(killed), before);
    EXPECT_EQ(fileText(killed + "-wal"), log);
    std::size_t files = 0;
    for (const auto& each : std::filesystem::directory_iterator(folder.path())) files += each.exists() ? 1 : 0;
    EXPECT_EQ(files, 4U); // SQLite left nothing in their folder
}
#endif
