// serve, record and replay from outside: what is served, recorded and played again has the edges of the file.
#include "core/gray/steady_window.h"
#include "core/io/save_scan.h"
#include "core/live/live_feed.h"
#include "core/method/pipeline.h"
#include "core/report/report.h"
#include "tests/support/run_program.h"
#include "tests/support/scans.h"
#include "tests/support/served_program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

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
    for (int wait = 0; wait < 2500; ++wait) {
        now = feed.sweep();
        if (now.scan && !now.progress.growing) break;
        if (now.scan) {
            static_cast<void>(pipeline.run(now.scan, window.fix(*now.scan, canny)));
            ++looks;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    ASSERT_TRUE(now.scan && !now.progress.growing) << now.progress.text() << ' ' << feed.status().session.sentence;
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

TEST_F(Live, NobodyThereIsSaid) {
    const auto record = runCli("record 127.0.0.1:9 -o " + (folder / "none.mcap").string() + " --seconds 1");
    EXPECT_EQ(record.code, 1);
    EXPECT_NE(record.err.find("127.0.0.1:9"), std::string::npos) << record.err;
    EXPECT_EQ(runCli("record host:99999 -o " + (folder / "x.mcap").string()).code, 2);
    EXPECT_EQ(runCli("replay " + scan).code, 1);
}

} // namespace
} // namespace edgescan
