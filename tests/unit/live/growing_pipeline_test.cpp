// Scans that grow: which of them continue which, the window that stays meanwhile, and what the operator is told of them.
#include "core/gray/canny.h"
#include "core/live/growing_pipeline.h"
#include "core/live/live_health.h"
#include "core/scan/placement.h"
#include "core/settings/presets.h"
#include "tests/support/live_lines.h"
#include "tests/support/live_session.h"
#include "tests/support/point_lists.h"

#include <map>
#include <set>

using namespace edgescan;
using namespace edgescan::test;

namespace {

/// Rows of a nearer wall first, then of a farther one: an automatic window wants to move.
Scan recedingScan(int lines, int beams) {
    return makeScan(lines, beams,
                    [&](int i, int j) { return 2000 + (i > lines / 2 ? 40 * i : 0) + (j / 10 % 2) * 300 + (i * 7 + j * 3) % 11; });
}

} // namespace

TEST(GrowingPipeline, EveryFrameIsThatOfItsOwnSettingsAndTheWindowRarelyMoves) {
    for (const Method method : {Method::Canny, Method::EdgeScanPlus}) {
        for (const Scaling scaling : {Scaling::Log, Scaling::Window, Scaling::Thesis}) {
            const Scan whole = recedingScan(200, 60);
            Settings settings;
            settings.method = method;
            settings.scaling = scaling;
            GrowingPipeline pipeline;
            std::set<std::pair<double, double>> windows;
            const int step = method == Method::Canny ? 3 : 17;
            for (int lines = 1; lines <= 200; lines += step) {
                const auto part = firstLines(whole, lines);
                const auto detection = pipeline.run(part, settings, {77, true, 200});
                ASSERT_EQ(*detection->mask, *detectEdges(part, detection->settings)->mask) << lines;
                ASSERT_FALSE(std::isnan(detection->settings.nearMm));
                EXPECT_EQ(detection->settings.lower, settings.lower);
                windows.insert({detection->settings.nearMm, detection->settings.farMm});
            }
            EXPECT_LE(windows.size(), 8U) << "once per doubling at most";
            const auto all = firstLines(whole, 200);
            const auto last = pipeline.run(all, settings, {77, false, 200});
            EXPECT_TRUE(last->settings == settings);
            EXPECT_EQ(*last->mask, *detectEdges(all, settings)->mask);
        }
    }
}

TEST(GrowingPipeline, ASliderLeavesTheWindowAlone) {
    const Scan whole = recedingScan(100, 50);
    GrowingPipeline pipeline;
    Settings settings = cannySettings();
    const auto before = pipeline.run(firstLines(whole, 40), settings, {5, true, 0});
    settings.lower += 3;
    settings.kernel = 5;
    const auto after = pipeline.run(firstLines(whole, 45), settings, {5, true, 0});
    EXPECT_EQ(after->settings.nearMm, before->settings.nearMm);
    EXPECT_EQ(after->settings.farMm, before->settings.farMm);
    EXPECT_EQ(after->settings.kernel, 5);
    EXPECT_EQ(*after->mask, *detectEdges(after->scan, after->settings)->mask);
    settings.nearMm = 1000;
    settings.farMm = 5000;
    const auto typed = pipeline.run(firstLines(whole, 46), settings, {5, true, 0});
    EXPECT_EQ(typed->settings.nearMm, 1000);
    EXPECT_EQ(typed->settings.farMm, 5000);
}

// Two sweeps of the same scene: the same first and last row, something else between.
TEST(GrowingPipeline, AnotherSweepIsNeverTakenForTheSame) {
    const Scan one = makeScan(40, 50, [](int, int j) { return j < 25 ? 3000 : 4000; });
    Scan two = one;
    for (int i = 10; i < 20; ++i) {
        for (int j = 10; j < 40; ++j) two.rangeMm.at(i, j) = 2000;
    }
    GrowingPipeline pipeline;
    const Settings settings = cannySettings();
    static_cast<void>(pipeline.run(firstLines(one, 39), settings, {1, true, 0}));
    const auto other = firstLines(two, 40);
    const auto detection = pipeline.run(other, settings, {2, true, 0});
    EXPECT_EQ(*detection->mask, *detectEdges(other, detection->settings)->mask);
    EXPECT_FALSE(edgeCells(*detection->mask).empty());
}

// What the number promises: as long as it is the same, rows that were there stay as they are.
TEST(Growth, ScansOfOneNumberContinueEachOther) {
    std::mt19937 random(8);
    int grown = 0;
    std::map<std::uint64_t, std::shared_ptr<const Scan>> last;
    for (int round = 0; round < 40; ++round) {
        SweepSettings settings;
        settings.expectedLines = round % 3 == 0 ? 40 : 0;
        settings.ticksPerDeg = round % 4 == 1 ? std::optional<double>(5.0) : std::nullopt;
        SweepAssembler assembler(settings);
        std::vector<std::uint64_t> numbers;
        for (int n = 0; n < 120; ++n) {
            if (random() % 9 == 0) continue; // lost
            LineStyle style;
            if (round % 2 == 1 && n % 2 == 1) style.startAngle += 833; // interlaced: two lines make a row
            ScanTelegram telegram = telegramOfLine(n, style);
            if (round % 4 == 1) { // there and back again
                const int turn = n % 60;
                telegram.encoders.push_back({static_cast<std::uint32_t>(1000 + (turn < 30 ? turn : 60 - turn)), 0});
            }
            assembler.push(telegram, hostNsOfLine(n));
            if (random() % 15 == 0) assembler.push(telegram, hostNsOfLine(n)); // twice
            const SweepSoFar now{assembler.snapshot(), assembler.progress()};
            if (!now.scan) continue;
            auto& before = last[now.progress.growth];
            if (before && now.scan->lines() >= before->lines()) {
                ASSERT_EQ(before->beams(), now.scan->beams());
                ASSERT_TRUE(std::equal(before->rangeMm.cells.begin(), before->rangeMm.cells.end(), now.scan->rangeMm.cells.begin())) << n;
                ASSERT_TRUE(std::equal(before->state.cells.begin(), before->state.cells.end(), now.scan->state.cells.begin())) << n;
                ++grown;
            }
            before = std::make_shared<const Scan>(*now.scan);
            EXPECT_NE(now.progress.growth, 0U);
            EXPECT_EQ(now.progress.growing, settings.expectedLines == 0 || now.progress.lines < settings.expectedLines);
        }
        assembler.finish();
        EXPECT_FALSE(assembler.progress().growing);
        for (const FinishedSweep& sweep : assembler.takeFinished()) EXPECT_FALSE(sweep.progress.growing);
    }
    EXPECT_GT(grown, 2000);
}

TEST(LiveHealth, TellsWhatTheStateIs) {
    LiveStatus status;
    status.session = {SessionPhase::Connecting, "Connecting to x:2112.", {}};
    EXPECT_EQ(healthOf(status).badge, "CONNECTING");
    EXPECT_FALSE(healthOf(status).stale());
    status.session.phase = SessionPhase::Lost;
    EXPECT_EQ(healthOf(status).badge, "LOST");
    status.session.phase = SessionPhase::Live;
    status.secondsSinceLine = 0.04;
    status.lines = 12;
    EXPECT_EQ(healthOf(status).badge, "LIVE");
    EXPECT_FALSE(healthOf(status).stale());
    // S4: two seconds at the latest, whatever the session thinks.
    status.secondsSinceLine = 1.99;
    EXPECT_EQ(healthOf(status).liveness, Liveness::Live);
    status.secondsSinceLine = 2.0;
    EXPECT_EQ(healthOf(status).badge, "STALE 2 s");
    EXPECT_TRUE(healthOf(status).stale());
    status.session.phase = SessionPhase::Stale;
    status.secondsSinceLine = 0.6;
    EXPECT_EQ(healthOf(status).badge, "STALE 0 s");
    status.session.phase = SessionPhase::Identifying; // connected again, but no line yet
    status.secondsSinceLine = 130;
    EXPECT_EQ(healthOf(status).badge, "STALE 2 min");
    status.session.phase = SessionPhase::Lost;
    status.secondsSinceLine = 7300;
    EXPECT_EQ(healthOf(status).badge, "LOST 2 h");
    status.session.phase = SessionPhase::Stopped;
    EXPECT_EQ(healthOf(status).badge, "STOPPED");
}

TEST(LiveHealth, TellsLinesLossesWindowPoseEndAndRecording) {
    LiveStatus status;
    status.session.phase = SessionPhase::Live;
    status.secondsSinceLine = 0.0;
    status.lines = 312;
    status.linesPerSecond = 25;
    status.sweep.lines = 312;
    status.sweep.received = 309;
    status.sweep.expected = 1000;
    status.sweep.lost = {5, 9, 10};
    status.sweep.cells[static_cast<std::size_t>(CellState::Valid)] = 958;
    status.sweep.cells[static_cast<std::size_t>(CellState::NoReturn)] = 42;
    LiveHealth health = healthOf(status);
    EXPECT_EQ(health.lines, "INCOMPLETE 309/1000 lines");
    EXPECT_EQ(health.lost, "3 lost: lines 5, 9 to 10");
    EXPECT_EQ(health.noReturn, "no return 4.2 %");
    EXPECT_EQ(health.end, "ends in 28 s");
    EXPECT_EQ(health.contamination, "window clean");
    EXPECT_EQ(health.pose, "no pose");
    EXPECT_TRUE(health.recording.empty());
    // S5: kept for the sweep even when it clears.
    status.sweep.device.contaminationWarning = status.sweep.deviceEver.contaminationWarning = true;
    EXPECT_EQ(healthOf(status).contamination, "WINDOW DIRTY");
    EXPECT_EQ(healthOf(status).window, Condition::OutOfSpec);
    status.sweep.device.contaminationWarning = false;
    EXPECT_EQ(healthOf(status).contamination, "WINDOW DIRTY earlier in this sweep");
    status.sweep.deviceEver.contaminationError = true;
    EXPECT_EQ(healthOf(status).window, Condition::Failure);
    status.sweep.deviceEver.error = true;
    EXPECT_EQ(healthOf(status).deviceState, "DEVICE ERROR earlier in this sweep");
    Placement placement;
    placement.ageSeconds = 14.9;
    EXPECT_EQ(healthOf(status, &placement).pose, "pose 14 s old");
    placement.ageSeconds = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(healthOf(status, &placement).pose, "pose of unknown age");
    status.recording = RecordingState{};
    status.recording->bytes = 1'240'000;
    EXPECT_EQ(healthOf(status).recording, "recording 1.2 MB");
    status.recording->problem = Error{"the disk is full", "/x.mcap", "free some space"};
    status.recording->ended = true;
    EXPECT_EQ(healthOf(status).recorded, Condition::Failure);
    EXPECT_TRUE(healthOf(status).recording.starts_with("RECORDING ENDED: "));
    status.sweep.lines = status.sweep.received = 1000;
    status.sweep.lost.clear();
    EXPECT_EQ(healthOf(status).end, "sweep whole");
    EXPECT_EQ(healthOf(status).lines, "1000/1000 lines");
}

TEST(LiveFeed, ARecordingBegunLateHoldsTheSweepFromItsBeginning) {
    EmulatedScannerSettings settings;
    settings.linesPerSecond = 300;
    settings.atEnd = AtEnd::Again;
    const Scan scan = countingScan(80, 30);
    const auto scanner = served(scan, settings);
    SweepSettings sweep;
    sweep.expectedLines = 80;
    const Folder folder;
    {
        LiveFeed feed(settingsFor(*scanner), sweep, [] {});
        // In the middle of the second sweep.
        for (int wait = 0; wait < 2000 && feed.status().lines < 110; ++wait) std::this_thread::sleep_for(2ms);
        ASSERT_TRUE(feed.startRecording(folder / "late.mcap"));
        EXPECT_FALSE(feed.startRecording(folder / "again.mcap"));
        for (int wait = 0; wait < 2000 && feed.status().lines < 165; ++wait) std::this_thread::sleep_for(2ms);
        EXPECT_NEAR(feed.status().linesPerSecond, 300, 150);
        ASSERT_TRUE(feed.stopRecording());
    }
    const auto opened = openRecording(folder / "late.mcap");
    ASSERT_TRUE(opened) << opened.error().sentence();
    ASSERT_EQ(opened->lines(), 80);
    for (int i = 0; i < 80; ++i) {
        for (int j = 0; j < 30; ++j) {
            ASSERT_EQ(opened->state.at(i, j), scan.state.at(i, j)) << i << ' ' << j;
            if (scan.state.at(i, j) == CellState::Valid) {
                ASSERT_EQ(opened->rangeMm.at(i, j), scan.rangeMm.at(i, j)) << i << ' ' << j;
            }
        }
    }
}
