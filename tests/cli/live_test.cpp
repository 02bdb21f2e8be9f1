// serve, record and replay from outside: what is served, recorded and played again has the edges of the file.
#include "core/gray/steady_window.h"
#include "core/io/save_scan.h"
#include "core/live/live_feed.h"
#include "core/method/pipeline.h"
#include "core/report/report.h"
#include "tests/support/live_lines.h"
#include "tests/support/point_lists.h"
#include "tests/support/run_program.h"
#include "tests/support/scans.h"
#include "tests/support/served_program.h"
#include "tests/support/wait_until.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <random>
#include <sstream>
#include <thread>

namespace edgescan {
namespace {

using nlohmann::json;
using test::runCli;

using Served = test::ServedProgram;

struct Live : public ::testing::Test {
    test::TemporaryFolder folder;
    std::string scan = (folder / "bell.json").string();

    void SetUp() override { ASSERT_EQ(runCli("simulate -o " + scan + " --lines 90 --beams 191 --axis spin").code, 0); }

    static std::string hashOf(const std::string& arguments) {
        const auto run = runCli("detect " + arguments + " --json -");
        EXPECT_EQ(run.code, 0) << run.err;
        return json::parse(run.out)["edge_mask_sha256"];
    }
};

TEST_F(Live, ServedRecordedAndPlayedAgainGivesTheMaskOfTheFile) {
    const std::string recording = (folder / "bell.mcap").string();
    {
        const Served served(scan + " --rate 0");
        const auto record =
            runCli("record " + served.address() + " -o " + recording + " --line-step 2 --lines 90 --expected-lines 90 --seconds 30");
        ASSERT_EQ(record.code, 0) << record.err;
        const json summary = json::parse(record.out);
        EXPECT_EQ(summary["lines"], 90);
        EXPECT_TRUE(summary["lost_lines"].empty());
    }
    const std::string expected = hashOf(scan);
    EXPECT_EQ(hashOf(recording), expected);
    const auto replay = runCli("replay " + recording);
    ASSERT_EQ(replay.code, 0) << replay.err;
    std::istringstream lines(replay.out);
    int count = 0;
    json last;
    for (std::string line; std::getline(lines, line); ++count) last = json::parse(line);
    EXPECT_EQ(count, 91); // a line each, and the result
    EXPECT_EQ(last["result"]["edge_mask_sha256"], expected);
}

// The whole way of a scan through the viewer's core: socket, assembly, edges while it grows, and the sweep as it ends.
TEST_F(Live, ASessionOfAThousandLinesEndsWithTheMaskOfTheFile) {
    const std::string bell = (folder / "draw-bell.json").string();
    ASSERT_EQ(runCli("simulate -o " + bell + " --lines 1000 --axis sweep").code, 0);
    const Served served(bell + " --rate 500 --split"); // so slow that there is a sweep to look at while it grows
    ASSERT_GT(served.port(), 0);
    SessionSettings scanner;
    scanner.host = "127.0.0.1";
    scanner.port = static_cast<std::uint16_t>(served.port());
    SweepSettings sweep;
    sweep.expectedLines = 1000;
    sweep.firstLineDeg = -90;
    sweep.degPerLine = 0.18;
    sweep.axis = Axis::Sweep;
    LiveFeed feed(scanner, sweep, [] {});
    Pipeline pipeline;
    SteadyWindow window;
    Settings canny;
    canny.method = Method::Canny;
    SweepSoFar now;
    int looks = 0;
    const bool ended = test::waitUntil([&] {
        now = feed.sweep();
        if (!now.scan) return false;
        if (!now.progress.growing) return true;
        static_cast<void>(pipeline.run(now.scan, window.fix(*now.scan, canny)));
        ++looks;
        return false;
    });
    ASSERT_TRUE(ended) << now.progress.text() << ' ' << feed.status().session.sentence;
    EXPECT_TRUE(now.progress.complete()) << now.progress.text();
    EXPECT_GT(looks, 3);
    EXPECT_EQ(maskSha256(*pipeline.run(now.scan, canny)->mask), hashOf(bell + " --method canny"));
    EXPECT_EQ(maskSha256(*detectEdges(now.scan, Settings{})->mask), hashOf(bell));
    // Kept growing until the end, with the window of the whole: the same again.
    EXPECT_EQ(maskSha256(*detectEdges(now.scan, SteadyWindow().fix(*now.scan, canny))->mask), hashOf(bell + " --method canny"));
}

TEST_F(Live, LostLinesAreTold) {
    const std::string recording = (folder / "lossy.mcap").string();
    const Served served(scan + " --rate 0 --lose-every 20 --split --merge --garbage-every 7");
    const auto record = runCli("record " + served.address() + " -o " + recording + " --lines 80 --expected-lines 90 --seconds 30");
    ASSERT_EQ(record.code, 0) << record.err;
    const json summary = json::parse(record.out);
    EXPECT_GE(summary["lost_lines"].size(), 3U);
    const json report = json::parse(runCli("info " + recording).out);
    EXPECT_GE(report["cells"]["lost"].get<int>(), 3 * 191);
    EXPECT_NE(report["warnings"].dump().find("INCOMPLETE"), std::string::npos) << report["warnings"];
}

TEST_F(Live, ARecordingOfASimulationOpensAsTheSameScan) {
    const std::string recording = (folder / "direct.mcap").string();
    ASSERT_EQ(runCli("simulate -o " + recording + " --lines 90 --beams 191 --axis spin").code, 0);
    EXPECT_EQ(hashOf(recording), hashOf(scan));
    ASSERT_EQ(runCli("convert " + scan + " " + (folder / "converted.mcap").string()).code, 0);
    EXPECT_EQ(hashOf((folder / "converted.mcap").string()), hashOf(scan));
}

// Played line by line or opened at once: the same report but for the times.
void expectReplayAsDetect(const std::string& recording) {
    SCOPED_TRACE(recording);
    const auto replay = runCli("replay --quiet " + recording);
    const auto detect = runCli("detect --json - " + recording);
    ASSERT_EQ(replay.code, detect.code) << replay.err << detect.err;
    if (detect.code != 0) {
        EXPECT_EQ(replay.err, detect.err);
        return;
    }
    json played = json::parse(replay.out)["result"];
    json opened = json::parse(detect.out);
    played.erase("timings_ms");
    opened.erase("timings_ms");
    EXPECT_EQ(played, opened);
}

// A scan with cells that telegrams alone cannot tell: masked, out of the window, lost, status codes, unlike beams.
Scan scanOfManyStates(unsigned seed) {
    Scan scan = test::makeScan({.axis = seed % 2 == 0 ? Axis::Spin : Axis::Sweep, .lines = 60, .beams = 80, .seed = seed});
    std::mt19937 random(seed);
    for (const CellState state : {CellState::Masked, CellState::OutOfWindow, CellState::Lost, CellState::Masked}) {
        const std::size_t first = random() % scan.cells();
        for (std::size_t k = first; k < std::min(scan.cells(), first + 300); ++k) scan.state[k] = state;
    }
    scan.statusCodes = {32759};
    for (std::size_t k = 7; k < scan.cells(); k += 97) {
        scan.rangeMm[k] = 32759;
        scan.state[k] = CellState::DeviceStatus;
    }
    return scan;
}

TEST_F(Live, ReplayAndDetectSayTheSameOfEveryRecording) {
    for (unsigned seed = 1; seed <= 4; ++seed) {
        const std::string states = (folder / ("states" + std::to_string(seed) + ".mcap")).string();
        ASSERT_TRUE(saveScan(scanOfManyStates(seed), states));
        expectReplayAsDetect(states);
        const std::string bell = (folder / ("bell" + std::to_string(seed) + ".mcap")).string();
        ASSERT_EQ(runCli("simulate -o " + bell + " --lines 50 --beams 120 --seed " + std::to_string(seed)).code, 0);
        expectReplayAsDetect(bell);
    }
    // Of two sweeps the one counts of which more was received, not the one with more rows.
    std::vector<RecordingMessagePtr> messages;
    for (int n = 0; n < 110; ++n) {
        const bool lost = n < 60 && n % 3 == 1;
        if (!lost) messages.push_back(test::lineMessage(n));
        messages.push_back(stepperMessage({n, n < 60 ? 0.2 * n : 0.2 * (120 - n), n < 60 ? 5.0 : -5.0, true, test::hostNsOfLine(n)}));
    }
    const std::string twoSweeps = (folder / "two-sweeps.mcap").string();
    ASSERT_TRUE(saveMessages(twoSweeps, metadataOf(SweepSettings{}), messages));
    EXPECT_EQ(json::parse(runCli("detect --json - " + twoSweeps).out)["lines"], 49);
    expectReplayAsDetect(twoSweeps);
}

TEST_F(Live, ReplayAndDetectSayTheSameOfTheSharedRecordings) {
    const std::filesystem::path shared = EDGESCAN_SHARED_DIR;
    std::vector<std::filesystem::path> recordings{shared / "protocol/vectors/sweep_demo.mcap"};
    if (!std::filesystem::exists(recordings.front())) GTEST_SKIP() << "../shared is absent: its recordings cannot be played";
    for (const auto& entry : std::filesystem::directory_iterator(shared / "data/hostile")) {
        if (entry.path().extension() == ".mcap") recordings.push_back(entry.path());
    }
    for (const auto& recording : recordings) expectReplayAsDetect(recording.string());
}

TEST_F(Live, NobodyThereIsSaid) {
    const auto record = runCli("record 127.0.0.1:9 -o " + (folder / "none.mcap").string() + " --seconds 1");
    EXPECT_EQ(record.code, 1);
    EXPECT_NE(record.err.find("127.0.0.1:9"), std::string::npos) << record.err;
    EXPECT_EQ(runCli("record host:99999 -o " + (folder / "x.mcap").string()).code, 2);
    EXPECT_EQ(runCli("replay " + scan).code, 1);
}

} // namespace
} // namespace edgescan
