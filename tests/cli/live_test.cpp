// serve, record and replay from outside: a scan that is served, recorded and played again has the edges of the file.
#include "app/lab/emulator/sent_sweep.h"
#include "app/lab/emulator/telegram.h"
#include "app/lab/sim/simulate.h"
#include "core/edges/gray/steady_window.h"
#include "core/edges/pipeline/pipeline.h"
#include "core/exports/report.h"
#include "core/files/live_feed/live_feed.h"
#include "core/files/open_save/save_scan.h"
#include "tests/support/live_lines.h"
#include "tests/support/point_lists.h"
#include "tests/support/run_program.h"
#include "tests/support/scans.h"
#include "tests/support/served_program.h"
#include "tests/support/shared_folder.h"
#include "tests/support/wait_until.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <random>
#include <sstream>
#include <thread>

namespace edgescan {
namespace {

using nlohmann::json;
using test::runCli;
using test::runLab;

using Served = test::ServedProgram;

struct Live : public ::testing::Test {
    test::TemporaryFolder folder;
    std::string scan = (folder / "bell.json").string();

    void SetUp() override { ASSERT_EQ(runLab("simulate -o " + scan + " --lines 90 --beams 191 --axis spin").code, 0); }

    static std::string hashOf(const std::string& arguments) {
        const auto run = runCli("detect " + arguments + " --json -");
        EXPECT_EQ(run.code, 0) << run.err;
        return json::parse(run.out)["edge_mask_sha256"];
    }
};

// Played line by line or opened at once: the same report except for the times.
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

TEST_F(Live, ServedRecordedAndPlayedAgainGivesTheMaskOfTheFile) {
    const std::string recording = (folder / "bell.mcap").string();
    {
        const Served served(scan + " --rate 0");
        const auto record =
            runCli("record " + served.address() + " -o " + recording + " --line-step 2 --lines 90 --expected-lines 90 --seconds 120");
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
    EXPECT_EQ(count, 91); // one per line, and the result
    EXPECT_EQ(last["result"]["edge_mask_sha256"], expected);
}

// A robot's bridge: its recording is a bag that opens, and plays, with the edges of the file.
TEST_F(Live, ABridgeThatIsRecordedAndReplayedHasTheEdgesOfTheFile) {
    const std::string recording = (folder / "robot.mcap").string();
    {
        const Served served(scan + " --bridge --rate 300");
        const auto record = runCli("record ws://" + served.address() + " -o " + recording + " --lines 90 --seconds 120");
        ASSERT_EQ(record.code, 0) << record.err;
        const json summary = json::parse(record.out);
        EXPECT_EQ(summary["lines"], 90);
        EXPECT_EQ(summary["mounting"]["assumed"], json::array()) << "the transforms say it: " << summary["mounting"];
        EXPECT_EQ(summary["mounting"]["axis"], json::parse(runCli("info " + scan).out)["axis"]);
        EXPECT_TRUE(summary["mounting"]["line_step_deg"].is_null());
    }
    const std::string expected = hashOf(scan);
    EXPECT_EQ(hashOf(recording), expected);
    const auto replay = runCli("replay " + recording);
    ASSERT_EQ(replay.code, 0) << replay.err;
    EXPECT_EQ(std::ranges::count(replay.out, '\n'), 91); // one per line, and the result
    const std::string last = replay.out.substr(replay.out.rfind('\n', replay.out.size() - 2) + 1);
    EXPECT_EQ(json::parse(last)["result"]["edge_mask_sha256"], expected);
    EXPECT_EQ(runCli("record wss://127.0.0.1 -o " + (folder / "y.mcap").string()).code, 2);
    const auto none = runCli("record ws://127.0.0.1:9 -o " + (folder / "y.mcap").string() + " --seconds 1");
    EXPECT_EQ(none.code, 1);
    EXPECT_NE(none.err.find("foxglove_bridge"), std::string::npos) << none.err;
}

// A recording with the flags that `serve` prints; the mirror has the same angle as the motor.
TEST_F(Live, CloudsOfABridgeThatAreRecordedHaveTheEdgesOfTheFile) {
    const std::string recording = (folder / "clouds.mcap").string();
    {
        const Served served(scan + " --bridge --cloud --loop --rate 20");
        const auto record = runCli("record ws://" + served.address() + " -o " + recording + " --lines 3 --seconds 120");
        ASSERT_EQ(record.code, 0) << record.err;
        const json summary = json::parse(record.out);
        EXPECT_EQ(summary["lines"], 3);
        EXPECT_EQ(summary["sweep"], "90/90 lines");
        EXPECT_EQ(summary["disk"]["messages"], 3);
        EXPECT_EQ(summary["mounting"]["assumed"], json::array());
        EXPECT_EQ(summary["telegrams"]["accounted_for"], true);
    }
    const std::string expected = hashOf(scan);
    EXPECT_EQ(hashOf(recording), expected);
    EXPECT_EQ(hashOf(recording + " --scan 2"), expected);
    const auto replay = runCli("replay " + recording);
    ASSERT_EQ(replay.code, 0) << replay.err;
    EXPECT_EQ(json::parse(replay.out)["result"]["edge_mask_sha256"], expected);
    EXPECT_EQ(runLab("emulate " + scan + " --cloud").code, 2) << "without --bridge";
}

TEST_F(Live, TheFlagsThatServeGivesMakeTheFileAgain) {
    const std::string bell = (folder / "draw-bell.json").string();
    const std::string recording = (folder / "draw-bell.mcap").string();
    ASSERT_EQ(runLab("simulate -o " + bell + " --lines 400 --beams 381 --axis sweep").code, 0);
    const Served served(bell + " --rate 0");
    const std::string flags = served.said()["record_flags"];
    EXPECT_EQ(flags, "--axis sweep --line-start -90 --line-step 0.45 --stop-and-go --expected-lines 400 --lines 400");
    const auto record = runCli("record " + served.address() + " -o " + recording + " --seconds 120 " + flags);
    ASSERT_EQ(record.code, 0) << record.err;
    EXPECT_TRUE(json::parse(record.out)["mounting"]["assumed"].empty());
    EXPECT_EQ(hashOf(recording), hashOf(bell));
}

TEST_F(Live, WhatNobodySaidOfTheMountingIsToldEverywhere) {
    const auto recorded = [&](const std::string& name, const std::string& flags) {
        const Served served(scan + " --rate 0"); // each recording begins with the first line
        const std::string path = (folder / name).string();
        const auto record = runCli("record " + served.address() + " -o " + path + " --lines 40 --seconds 120 " + flags);
        EXPECT_EQ(record.code, 0) << record.err;
        return std::pair(path, json::parse(record.out));
    };
    const auto warningsIn = [](const json& document) { return document["warnings"].dump(); };
    const std::string both = "ASSUMED: the axis (spin), the step from line to line (0.18 degrees, the motor turning on while a line is "
                             "measured), the angle of the "
                             "first line (0 degrees). Give --axis, --line-step, --line-start where that is wrong. The first line received "
                             "is taken as line 0 of the sweep.";
    const auto [nothing, summary] = recorded("nothing.mcap", "");
    EXPECT_EQ(summary["mounting"]["assumed"], (json{"axis", "line_step_deg", "line_start_deg"}));
    EXPECT_TRUE(summary["mounting"]["expected_lines"].is_null());
    EXPECT_NE(warningsIn(summary).find(both), std::string::npos) << warningsIn(summary);
    const auto detect = runCli("detect " + nothing + " --json - --edges " + (folder / "edges.csv").string());
    EXPECT_NE(warningsIn(json::parse(detect.out)).find(both), std::string::npos) << detect.out;
    EXPECT_NE(test::fileText(folder / "edges.csv.provenance.json").find(both), std::string::npos);
    EXPECT_NE(runCli("info " + nothing).out.find("ASSUMED: the axis (spin)"), std::string::npos);
    EXPECT_NE(runCli("replay --quiet " + nothing).out.find(both), std::string::npos);
    EXPECT_EQ(runCli("info " + nothing + " --axis spin --line-step 2").out.find("ASSUMED"), std::string::npos);
    const std::string whenOpened = runCli("detect --json - " + nothing + " --axis sweep --line-step 2").out;

    const auto [step, stepGiven] = recorded("step.mcap", "--line-step 2 --expected-lines 90");
    EXPECT_EQ(stepGiven["mounting"]["assumed"], (json{"axis", "line_start_deg"}));
    EXPECT_NE(
        warningsIn(stepGiven).find("ASSUMED: the axis (spin), the angle of the first line (0 degrees). Give --axis, --line-start where"),
        std::string::npos)
        << warningsIn(stepGiven);
    const auto [all, allGiven] = recorded("all.mcap", "--line-step 2 --axis sweep");
    // A sweep that begins at another angle looks in another direction; a spin is only turned about the vertical.
    EXPECT_EQ(allGiven["mounting"]["assumed"], json{"line_start_deg"});
    EXPECT_NE(warningsIn(allGiven).find("ASSUMED: the angle of the first line (0 degrees). Give --line-start where"), std::string::npos)
        << warningsIn(allGiven);
    EXPECT_NE(whenOpened.find("ASSUMED: the angle of the first line (0 degrees). Give --line-start where"), std::string::npos)
        << whenOpened;
    const auto [half, halfGiven] = recorded("half.mcap", "--line-step 2 --axis sweep --expected-lines 90");
    EXPECT_NE(warningsIn(halfGiven).find("ASSUMED: the angle of the first line (-90 degrees)"), std::string::npos) << warningsIn(halfGiven);
    const auto [spin, spinGiven] = recorded("spin.mcap", "--line-step 2 --axis spin");
    EXPECT_TRUE(spinGiven["mounting"]["assumed"].empty());
    EXPECT_EQ(warningsIn(spinGiven).find("ASSUMED"), std::string::npos) << warningsIn(spinGiven);
    // Flags given on opening give the same result as flags given on recording.
    EXPECT_EQ(json::parse(whenOpened)["edge_mask_sha256"], hashOf(all));

    std::ofstream(folder / "robot.json")
        << R"({"format": "edgescan-calibration/1", "robot": "R", "stepper": {"axis": [1, 0, 0], "step_deg": 2}})";
    const auto [robot, robotSaid] = recorded("robot.mcap", "--calibration " + (folder / "robot.json").string());
    EXPECT_TRUE(robotSaid["mounting"]["assumed"].empty());
    EXPECT_EQ(robotSaid["mounting"]["axis"], "sweep");
    EXPECT_EQ(robotSaid["mounting"]["line_step_deg"], 2);
}

TEST_F(Live, WhereNothingComesItIsSaidOnceAndWhy) {
    const std::string recording = (folder / "none.mcap").string();
    const auto record = runCli("record 127.0.0.1:1 -o " + recording + " --seconds 1"); // no program listens on this port
    EXPECT_NE(record.code, 0);
    const std::string why =
        "edgescan-cli: 127.0.0.1:1: the connection is refused; check the port (2111 or 2112) and that no other program holds the scanner.";
    EXPECT_EQ(record.err, why + " Trying again in 0.5 s. Ctrl+C ends.\n" + why + "\n");
    EXPECT_FALSE(std::filesystem::exists(recording));
}

// A scan's whole path through the viewer's core: socket, assembly, edges while the sweep grows, and the completed sweep.
TEST_F(Live, ASessionOfAThousandLinesEndsWithTheMaskOfTheFile) {
    const std::string bell = (folder / "draw-bell.json").string();
    ASSERT_EQ(runLab("simulate -o " + bell + " --lines 1000 --axis sweep").code, 0);
    const Served served(bell + " --rate 500 --split-sends"); // so slow that the sweep can be observed while it grows
    ASSERT_GT(served.port(), 0);
    scanner::ConnectionSettings scanner;
    scanner.host = "127.0.0.1";
    scanner.port = static_cast<std::uint16_t>(served.port());
    scanner::SweepSettings sweep;
    sweep.expectedLines = 1000;
    sweep.firstLineDeg = -90;
    sweep.degPerLine = 0.18;
    sweep.axis = Axis::Sweep;
    files::LiveFeed feed(scanner, sweep, [] {});
    edges::Pipeline pipeline;
    edges::SteadyWindow window;
    edges::Settings canny;
    canny.method = edges::Method::Canny;
    scanner::SweepState now;
    int looks = 0;
    const bool ended = test::waitUntil([&] {
        now = feed.sweep();
        if (!now.scan) return false;
        if (!now.progress.growing) return true;
        static_cast<void>(pipeline.run(now.scan, window.fix(*now.scan, canny)));
        ++looks;
        return false;
    });
    ASSERT_TRUE(ended) << now.progress.text() << ' ' << feed.status().connection.sentence;
    EXPECT_TRUE(now.progress.complete()) << now.progress.text();
    EXPECT_GT(looks, 3);
    EXPECT_EQ(exports::maskSha256(*pipeline.run(now.scan, canny)->mask), hashOf(bell + " --method canny"));
    EXPECT_EQ(exports::maskSha256(*edges::detectEdges(now.scan, edges::Settings{})->mask), hashOf(bell));
    // Treated as growing until the end, with the gray window of the whole scan: the same result.
    EXPECT_EQ(exports::maskSha256(*edges::detectEdges(now.scan, edges::SteadyWindow().fix(*now.scan, canny))->mask),
              hashOf(bell + " --method canny"));
}

TEST_F(Live, ExactlyTheLinesThatWereAskedForAreRecorded) {
    for (const int lines : {1, 20, 33}) {
        SCOPED_TRACE(lines);
        const Served served(scan + " --rate 400");
        const std::string recording = (folder / ("exact" + std::to_string(lines) + ".mcap")).string();
        const auto record = runCli("record " + served.address() + " -o " + recording + " --seconds 30 --lines " + std::to_string(lines));
        ASSERT_EQ(record.code, 0) << record.err;
        const json summary = json::parse(record.out);
        EXPECT_EQ(summary["lines"], lines);
        EXPECT_GE(summary["lines_after"].get<int>(), 0);
        EXPECT_EQ(summary["telegrams"]["received"], lines) << summary;
        EXPECT_EQ(json::parse(runCli("info " + recording).out)["lines"], lines);
    }
}

/// Sends the same answer without an end to everyone who connects.
class Flood {
public:
    explicit Flood(std::string answer) : listening_(::socket(AF_INET, SOCK_STREAM, 0)) {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t size = sizeof address;
        const auto plain = reinterpret_cast<sockaddr*>(&address);
        if (::bind(listening_, plain, size) != 0 || ::listen(listening_, 4) != 0 || ::getsockname(listening_, plain, &size) != 0) return;
        address_ = "127.0.0.1:" + std::to_string(ntohs(address.sin_port));
        std::string many;
        while (many.size() < (1U << 20U)) many += answer;
        sending_ = std::thread([this, many = std::move(many)] {
            for (int peer = 0; (peer = ::accept(listening_, nullptr, nullptr)) >= 0; ::close(peer)) {
                while (::send(peer, many.data(), many.size(), MSG_NOSIGNAL) > 0) {
                }
            }
        });
    }
    ~Flood() {
        ::shutdown(listening_, SHUT_RDWR);
        if (sending_.joinable()) sending_.join();
        ::close(listening_);
    }
    Flood(const Flood&) = delete;
    Flood& operator=(const Flood&) = delete;
    [[nodiscard]] const std::string& address() const { return address_; }

private:
    int listening_;
    std::string address_;
    std::thread sending_;
};

TEST_F(Live, ARecordingEndsWhateverThePeerSends) {
    const std::vector<std::string> answers{"\x02sRA SCdevicestate 1\x03", "\x02s\x03", std::string("\x02\x02\x02\x02\0\0\1\0", 8)};
    for (const std::string& answer : answers) {
        const Flood flood(answer);
        const std::string recording = (folder / ("flood" + std::to_string(answer.size()) + ".mcap")).string();
        const auto record = runCli("record " + flood.address() + " -o " + recording + " --seconds 1");
        EXPECT_EQ(record.code, 1) << record.out;
        EXPECT_FALSE(record.err.empty()); // that no line came, or that the disk is slower than the flood
    }
}

TEST_F(Live, LostLinesAreTold) {
    const std::string recording = (folder / "lossy.mcap").string();
    const Served served(scan + " --rate 0 --lose-every 20 --split-sends --merge-sends --garbage-every 7");
    const auto record = runCli("record " + served.address() + " -o " + recording + " --lines 80 --expected-lines 90 --seconds 120");
    ASSERT_EQ(record.code, 0) << record.err;
    const json summary = json::parse(record.out);
    EXPECT_GE(summary["lost_lines"].size(), 3U);
    const json report = json::parse(runCli("info " + recording).out);
    EXPECT_GE(report["cells"]["lost"].get<int>(), 3 * 191);
    EXPECT_NE(report["warnings"].dump().find("INCOMPLETE"), std::string::npos) << report["warnings"];
}

// The same live: the summary counts and reports them, and the file contains them.
TEST_F(Live, CountersBeamsAndClocksThatAreWrongAreToldWhileTheyAreRecorded) {
    struct Case {
        const char* flag;
        const char* key;
        const char* word;
        const char* sweep;
    };
    for (const Case& each : {Case{"--counter-step 1000", "counter_jumps", "jumped ahead", "90/90 lines, COUNTERS IN DOUBT"},
                             Case{"--clock-rate -1", "clock_jumps", "clock was set", "90/90 lines"},
                             Case{"--clock-rate 0", "clock_stands", "clock stood still", "90/90 lines"},
                             Case{"--narrow-every 2", nullptr, "lines of the sweeps are lost", "INCOMPLETE 45/90 lines"}}) {
        SCOPED_TRACE(each.flag);
        const Served served(scan + " --rate 0 " + each.flag);
        const std::string recording =
            (folder / (std::string(each.flag).substr(2, 5) + each.flag[std::string(each.flag).size() - 1] + ".mcap")).string();
        const auto record =
            runCli("record " + served.address() + " -o " + recording + " --line-step 2 --lines 90 --expected-lines 90 --seconds 120");
        ASSERT_EQ(record.code, 0) << record.err;
        const json summary = json::parse(record.out);
        EXPECT_EQ(summary["sweep"], each.sweep);
        EXPECT_EQ(summary["lines"], 90);
        EXPECT_EQ(summary["telegrams"]["placed"], 90);
        EXPECT_EQ(summary["telegrams"]["accounted_for"], true);
        EXPECT_NE(summary["warnings"].dump().find(each.word), std::string::npos) << summary["warnings"];
        if (each.key != nullptr) {
            EXPECT_GE(summary["irregular"][each.key].get<int>(), 85) << summary["irregular"];
        } else {
            EXPECT_EQ(summary["lost_lines"].size(), 45U);
            EXPECT_EQ(summary["sweeps"]["cells_lost"], 45 * 95);
        }
        expectReplayAsDetect(recording);
    }
}

TEST_F(Live, ARecordingOfASimulationOpensAsTheSameScan) {
    const std::string recording = (folder / "direct.mcap").string();
    ASSERT_EQ(runLab("simulate -o " + recording + " --lines 90 --beams 191 --axis spin").code, 0);
    EXPECT_EQ(hashOf(recording), hashOf(scan));
    ASSERT_EQ(runCli("convert " + scan + " " + (folder / "converted.mcap").string()).code, 0);
    EXPECT_EQ(hashOf((folder / "converted.mcap").string()), hashOf(scan));
}

// A scan with cells that telegrams alone cannot distinguish: masked, out of the window, lost, status codes, unlike beams.
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
        ASSERT_TRUE(files::saveScan(scanOfManyStates(seed), states));
        expectReplayAsDetect(states);
        const std::string bell = (folder / ("bell" + std::to_string(seed) + ".mcap")).string();
        ASSERT_EQ(runLab("simulate -o " + bell + " --lines 50 --beams 120 --seed " + std::to_string(seed)).code, 0);
        expectReplayAsDetect(bell);
    }
    // Of two sweeps, the one with more received lines counts, not the one with more rows.
    std::vector<files::RecordingMessagePtr> messages;
    for (int n = 0; n < 110; ++n) {
        const bool lost = n < 60 && n % 3 == 1;
        if (!lost) messages.push_back(test::lineMessage(n));
        messages.push_back(
            files::stepperMessage({n, n < 60 ? 0.2 * n : 0.2 * (120 - n), n < 60 ? 5.0 : -5.0, true, test::hostNsOfLine(n)}));
    }
    const std::string twoSweeps = (folder / "two-sweeps.mcap").string();
    ASSERT_TRUE(files::saveMessages(twoSweeps, scanner::metadataOf(scanner::SweepSettings{}), messages));
    EXPECT_EQ(json::parse(runCli("detect --json - " + twoSweeps).out)["lines"], 49);
    expectReplayAsDetect(twoSweeps);
}

/// Messages of a scanner with faults of all kinds, including wrong counters and clocks; every seed gives another mixture.
std::vector<files::RecordingMessagePtr> faultyMessages(unsigned seed) {
    std::mt19937 random(seed);
    const auto maybe = [&](int every) { return random() % 2 == 0 ? every : 0; };
    sim::SimulationSettings bell;
    bell.lines = 60;
    bell.beams = 90 + static_cast<int>(random() % 60);
    bell.seed = seed;
    auto simulated = sim::simulate(bell);
    auto telegrams = scanner::telegramsOf(simulated->scan);
    EXPECT_TRUE(telegrams);
    scanner::EmulatedScannerSettings settings;
    settings.atEnd = random() % 2 == 0 ? scanner::AtEnd::Again : scanner::AtEnd::Reverse;
    settings.contaminationWarning = random() % 4 == 0;
    settings.faults.byChance = true;
    settings.faults.seed = seed;
    settings.faults.loseEvery = maybe(20);
    settings.faults.loseBurst = 1 + static_cast<int>(random() % 5);
    settings.faults.duplicateEvery = maybe(15);
    settings.faults.corruptEvery = maybe(25);
    settings.faults.garbageEvery = maybe(25);
    const int counterJumps = maybe(30), clockJumps = maybe(30), narrow = maybe(20), late = maybe(20);
    scanner::EmulatedSweep sweep(std::make_shared<const std::vector<scanner::ScanTelegram>>(std::move(*telegrams)), settings);
    std::vector<files::RecordingMessagePtr> messages;
    const auto happens = [&](int every) { return every > 0 && random() % static_cast<unsigned>(every) == 0; };
    for (int n = 0; n < 150; ++n) {
        auto step = sweep.next();
        if (!step || step->lost) continue;
        if (happens(counterJumps)) step->telegram.telegramCounter = static_cast<std::uint16_t>(random());
        if (happens(clockJumps)) step->telegram.sinceStartUs = static_cast<std::uint32_t>(random());
        if (happens(narrow)) step->telegram.channels16.front().values.resize(40);
        const Bytes frame = scanner::framed(scanner::encodeScanTelegram(step->telegram, scanner::Dialect::B), scanner::Dialect::B);
        const auto post = [&](Bytes bytes) {
            messages.push_back(std::make_shared<const files::RecordingMessage>(
                files::RecordingMessage{files::RecordingTopic::ColaRx, test::hostNsOfLine(n), std::move(bytes)}));
        };
        if (step->garbage) post(sweep.garbage());
        post(step->corrupt ? sweep.corrupted(frame) : frame);
        if (step->duplicate) post(frame);
        if (happens(late) && messages.size() > 4) std::swap(messages.back(), messages[messages.size() - 3]);
    }
    return messages;
}

TEST_F(Live, ReplayAndDetectSayTheSameOfFaultyScanners) {
    for (unsigned seed = 1; seed <= 40; ++seed) {
        scanner::SweepSettings settings;
        settings.expectedLines = seed % 3 == 0 ? 60 : 0;
        settings.degPerLine = 3.0;
        const std::string path = (folder / ("faulty" + std::to_string(seed) + ".mcap")).string();
        ASSERT_TRUE(files::saveMessages(path, scanner::metadataOf(settings), faultyMessages(seed)));
        expectReplayAsDetect(path);
    }
}

// Every command reports all faults of the telegrams.
TEST_F(Live, CountersBeamsAndClocksThatAreWrongAreToldByEveryCommand) {
    struct Case {
        const char* word;
        std::function<void(scanner::ScanTelegram&, int)> spoil;
    };
    const std::vector<Case> cases{
        {"jumped ahead", [](scanner::ScanTelegram& t, int n) { t.telegramCounter = t.scanCounter = static_cast<std::uint16_t>(1000 * n); }},
        {"clock was set", [](scanner::ScanTelegram& t, int n) { t.sinceStartUs = 4'000'000'000U - 40'000U * static_cast<unsigned>(n); }},
        {"fewer beams",
         [](scanner::ScanTelegram& t, int n) {
             if (n % 2 == 1) t.channels16.front().values.resize(30);
         }},
    };
    for (const Case& each : cases) {
        SCOPED_TRACE(each.word);
        std::vector<scanner::ScanTelegram> telegrams;
        std::vector<files::RecordingMessagePtr> messages;
        for (int n = 0; n < 60; ++n) {
            scanner::ScanTelegram telegram = test::telegramOfLine(n);
            each.spoil(telegram, n);
            const Bytes frame = scanner::framed(scanner::encodeScanTelegram(telegram, scanner::Dialect::B), scanner::Dialect::B);
            messages.push_back(std::make_shared<const files::RecordingMessage>(
                files::RecordingMessage{files::RecordingTopic::ColaRx, test::hostNsOfLine(n), frame}));
        }
        const std::string path = (folder / (std::string(each.word).substr(0, 5) + ".mcap")).string();
        ASSERT_TRUE(files::saveMessages(path, scanner::metadataOf(scanner::SweepSettings{}), messages));
        expectReplayAsDetect(path);
        for (const char* command : {"info ", "detect --json - ", "replay --quiet "})
            EXPECT_NE(runCli(command + path).out.find(each.word), std::string::npos) << command << runCli(command + path).out;
        const std::string edges = (folder / "edges.json").string();
        ASSERT_EQ(runCli("detect " + path + " --edges " + (folder / "edges.ply").string()).code, 0);
        EXPECT_NE(test::fileText(folder / "edges.ply.provenance.json").find(each.word), std::string::npos) << "the record of the export";
    }
}

TEST_F(Live, ReplayAndDetectSayTheSameOfTheSharedRecordings) {
    EDGESCAN_NEEDS_SHARED("protocol/vectors");
    const std::filesystem::path shared = test::sharedFolder();
    std::vector<std::filesystem::path> recordings{shared / "protocol/vectors/sweep_demo.mcap"};
    for (const auto& entry : std::filesystem::recursive_directory_iterator(shared / "data")) {
        if (entry.path().extension() == ".mcap") recordings.push_back(entry.path());
    }
    EXPECT_GE(recordings.size(), 7U);
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
