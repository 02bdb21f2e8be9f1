// Session files: a written session is read back unchanged, and a damaged one is never partly loaded.
#include "core/inspect/session_file/session_file.h"
#include "core/scan/grid/acquisition.h"

#include "core/base/whole_file.h"
#include "tests/support/damage.h"
#include "tests/support/example_session.h"
#include "tests/support/folders.h"
#include "tests/support/run_program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <random>

namespace edgescan::inspect {
namespace {

namespace fs = std::filesystem;

TEST(SessionFile, IsReadBackAsItWasWritten) {
    const test::TemporaryFolder folder;
    const ViewerState before = test::exampleSession(folder.path() / "scans" / "bell.json");
    const std::string text = sessionText(before, folder.path() / "sessions", "2026-11-21T08:00:00Z");
    const auto read = sessionFromText(text, folder.path() / "sessions", "test");
    ASSERT_TRUE(bool(read)) << read.error().sentence();
    const ViewerState& now = read->state;
    EXPECT_EQ(read->savedUtc, "2026-11-21T08:00:00Z");
    EXPECT_EQ(now.tuning.settings, before.tuning.settings);
    EXPECT_EQ(now.targets.notebook, before.targets.notebook);
    EXPECT_EQ(now.targets.active, before.targets.active);
    EXPECT_EQ(now.selection.selected, before.selection.selected);
    EXPECT_EQ(now.selection.hidden, before.selection.hidden);
    EXPECT_EQ(now.marks.wanted, before.marks.wanted);
    EXPECT_EQ(now.marks.unwanted, before.marks.unwanted);
    EXPECT_EQ(now.rocks->settings, before.rocks->settings);
    EXPECT_EQ(now.rocks->edits, before.rocks->edits);
    EXPECT_EQ(now.earlier->settings, before.earlier->settings);
    EXPECT_EQ(now.earlier->scan.path, before.earlier->scan.path);
    ASSERT_EQ(now.layers.size(), 2U);
    EXPECT_EQ(now.layers[0].place, before.layers[0].place);
    EXPECT_EQ(now.layers[1].scan.path, before.layers[1].scan.path);
    EXPECT_FALSE(now.layers[1].visible || now.layers[1].place);
    EXPECT_EQ(now.view.camera, before.view.camera);
    EXPECT_EQ(now.view.images, before.view.images);
    EXPECT_EQ(now.switches, before.switches);
    EXPECT_EQ(now.looks, before.looks);
    EXPECT_EQ(now.layout, before.layout);
    EXPECT_EQ(now.scan.reading.unitMm, 2.5);
    EXPECT_EQ(now.scan.reading.pose, before.scan.reading.pose);
    EXPECT_EQ(sessionText(now, folder.path() / "sessions", "2026-11-21T08:00:00Z"), text);
}

TEST(SessionFile, OneThatAnEarlierEdgeScanWroteOpensWithTheSameResult) {
    const auto bytes = readWholeFile(test::sourceFolder() + "/tests/unit/inspect/session_file/written_by_0.1.0.edgescan-session.json");
    ASSERT_TRUE(bool(bytes));
    const auto read = sessionFromText(textOf(*bytes), "/sessions", "test");
    ASSERT_TRUE(bool(read)) << read.error().sentence();
    EXPECT_EQ(read->state.keptIn, "/sessions/day.edgescan-session.json");
    // All that it said is said again; what is said more did not exist then.
    auto then = nlohmann::json::parse(textOf(*bytes));
    then.erase("program");
    const auto now = nlohmann::json::parse(sessionText(read->state, "/sessions", read->savedUtc));
    auto both = now;
    both.merge_patch(then);
    EXPECT_EQ(both, now);
}

TEST(SessionFile, IsFoundAgainWhenItMovedWithItsScan) {
    const test::TemporaryFolder folder;
    const fs::path old = folder.path() / "old", moved = folder.path() / "moved";
    fs::create_directories(old / "scans");
    ASSERT_TRUE(bool(writeWholeFile(old / "scans" / "bell.json", std::string("{}"))));
    const std::string path = (old / ("day" + std::string(kSessionEnding))).string();
    ASSERT_TRUE(bool(writeWholeFile(path, sessionText(test::exampleSession(old / "scans" / "bell.json"), old, ""))));
    const auto there = readSession(path);
    ASSERT_TRUE(bool(there));
    EXPECT_EQ(there->state.scan.path, old / "scans" / "bell.json");
    fs::rename(old, moved);
    const auto after = readSession(moved / ("day" + std::string(kSessionEnding)));
    ASSERT_TRUE(bool(after));
    EXPECT_EQ(after->state.scan.path, moved / "scans" / "bell.json");
    ASSERT_EQ(after->places.size(), 2U); // else where it was
    EXPECT_EQ(after->places.back(), old / "scans" / "bell.json");
    // A session elsewhere has the whole path alone.
    const auto far = sessionFromText(sessionText(test::exampleSession(moved / "scans" / "bell.json"), "/some/where/else", ""), "/", "test");
    ASSERT_TRUE(bool(far));
    EXPECT_EQ(far->places, std::vector<fs::path>{moved / "scans" / "bell.json"});
}

TEST(SessionFile, ARecordingThatLostItsEndKeepsWhatIsStillThere) {
    Scan scan;
    scan.rangeMm = Grid<float>(40, 30);
    for (std::size_t k = 0; k < scan.cells(); ++k) scan.rangeMm[k] = static_cast<float>(1000 + k);
    ViewerState before = test::exampleSession("/recordings/sweep.mcap");
    before.scan.kind = SessionScan::Kind::Recording;
    before.scan.identity.sha256.clear();
    before.scan.head = scanHead(scan);
    EXPECT_EQ(before.scan.head.lines, 16);
    const auto read = sessionFromText(sessionText(before, "/sessions", ""), "/sessions", "test");
    ASSERT_TRUE(bool(read)) << read.error().sentence();
    EXPECT_EQ(read->state.scan.kind, SessionScan::Kind::Recording);
    EXPECT_EQ(read->state.scan.head, before.scan.head);
    EXPECT_EQ(read->places, std::vector<fs::path>{"/recordings/sweep.mcap"});
    // Lines that came later change nothing, another sweep does.
    Scan longer = scan;
    longer.rangeMm = Grid<float>(60, 30);
    std::ranges::copy(scan.rangeMm.cells, longer.rangeMm.cells.begin());
    EXPECT_EQ(scanHead(longer, 16), before.scan.head);
    longer.rangeMm[3] += 1.0F;
    EXPECT_NE(scanHead(longer, 16), before.scan.head);
    // Of two sweeps with the same ranges, the start decides.
    SessionScan timed = before.scan;
    timed.identity.beams = scan.beams();
    timed.startS = 1.7e9;
    ViewerState stored = before;
    stored.scan.startS = timed.startS;
    const auto again = sessionFromText(sessionText(stored, "/sessions", ""), "/sessions", "test");
    ASSERT_TRUE(bool(again)) << again.error().sentence();
    EXPECT_EQ(again->state.scan.startS, timed.startS);
    for (const auto& [startS, isIt] : {std::pair(1.7e9 + 0.1, true), {1.7e9 + 40.0, false}}) {
        Acquisition acquisition;
        acquisition.lineTimesS = {startS};
        scan.acquisition = std::make_shared<const Acquisition>(std::move(acquisition));
        EXPECT_EQ(isSweepOf(timed, scan), isIt);
    }
    // Cells that were lost are named no more.
    const ViewerState whole = cutTo(before, 120000);
    EXPECT_EQ(sessionText(whole, "/sessions", ""), sessionText(before, "/sessions", ""));
    const ViewerState cut = cutTo(before, 100);
    EXPECT_EQ(cut.targets.notebook.targets.size(), 1U);
    EXPECT_TRUE(cut.targets.notebook.measures.empty());
    EXPECT_EQ(cut.targets.active, 77U);
    EXPECT_EQ(cut.selection.selected, (std::vector<CellRun>{{5, 3}}));
    EXPECT_EQ(cut.selection.hidden, (std::vector<CellRun>{{0, 2}}));
    EXPECT_EQ(cutTo(before, 6).selection.selected, (std::vector<CellRun>{{5, 1}}));
    EXPECT_FALSE(cutTo(before, 77).targets.active);
    EXPECT_EQ(cutTo(before, 25).rocks->edits.size(), 1U);
    EXPECT_TRUE(cutTo(before, 9).marks.wanted == std::vector<std::uint32_t>{3} && cutTo(before, 9).marks.unwanted.empty());
}

TEST(SessionFile, RefusesWhatDoesNotFitItsScan) {
    const std::string text = sessionText(test::exampleSession("/scans/bell.json"), "/sessions", "");
    const auto refused = [&text](const std::string& what, const std::string& instead, const std::string& word) {
        std::string damaged = text;
        const auto at = damaged.find(what);
        ASSERT_NE(at, std::string::npos) << what;
        damaged.replace(at, what.size(), instead);
        const auto read = sessionFromText(damaged, "/sessions", "test");
        ASSERT_FALSE(bool(read)) << instead;
        EXPECT_NE(read.error().sentence().find(word), std::string::npos) << read.error().sentence();
    };
    refused("edgescan-session/1", "edgescan-session/9", "this is not a session");
    refused("\"active\": 77", "\"active\": 120000", "active");
    refused("\"lines\": 100", "\"lines\": 0", "scan.lines");
    refused("\"beams\": 1200", "\"beams\": 1000001", "scan.beams");
    refused("\"looks\": {", "\"looks\": {\"x\": 3, ", "looks");
    refused("\"switches\": {", "\"switches\": {\"x\": 3, ", "switches");
    refused("\"kind\": \"file\"", "\"kind\": \"moon\"", "scan.kind");
    refused("\"preset\"", "\"pre set\"", "pre set");
    refused("\"edge\": [", "\"edge\": [5, 5, ", "twice");
    refused("\"view_angle_deg\": 40.0", "\"view_angle_deg\": 0", "view_angle_deg");
}

TEST(SessionFile, DamagedOnesGiveASentence) {
    const std::string text = sessionText(test::exampleSession("/scans/bell.json"), "/sessions", "");
    std::mt19937 random(7);
    for (int round = 0; round < 400; ++round) {
        const auto read = sessionFromText(test::damaged(text, random, round), "/sessions", "test");
        EXPECT_TRUE(read || read.error().sentence().ends_with("."));
    }
}

} // namespace
} // namespace edgescan::inspect
