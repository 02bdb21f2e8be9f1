// The operator's status of a live scan, and the content of a recording that is started late.
#include "core/files/live_feed/live_health.h"
#include "core/scan/grid/assumed_mounting.h"
#include "core/scan/grid/placement.h"
#include "tests/support/live_session.h"
#include "tests/support/point_lists.h"

using namespace edgescan;
using namespace edgescan::files;
using namespace edgescan::test;

TEST(LiveHealth, TellsWhatTheStateIs) {
    LiveStatus status;
    status.connection = {scanner::ConnectionPhase::Connecting, "Connecting to x:2112.", {}};
    EXPECT_EQ(healthOf(status).badge, "CONNECTING");
    EXPECT_FALSE(healthOf(status).stale());
    status.connection.phase = scanner::ConnectionPhase::Lost;
    EXPECT_EQ(healthOf(status).badge, "NOT CONNECTED");
    status.connection.phase = scanner::ConnectionPhase::Live;
    status.secondsSinceLine = 0.04;
    status.lines = 12;
    EXPECT_EQ(healthOf(status).badge, "LIVE");
    EXPECT_FALSE(healthOf(status).stale());
    // S4: two seconds at the latest, whatever the state of the session.
    status.secondsSinceLine = 1.99;
    EXPECT_EQ(healthOf(status).liveness, Liveness::Live);
    status.secondsSinceLine = 2.0;
    EXPECT_EQ(healthOf(status).badge, "STALE 2 s");
    EXPECT_TRUE(healthOf(status).stale());
    status.connection.phase = scanner::ConnectionPhase::Stale;
    status.secondsSinceLine = 0.6;
    EXPECT_EQ(healthOf(status).badge, "STALE 0 s");
    status.connection.phase = scanner::ConnectionPhase::Identifying; // connected again, but no line yet
    status.secondsSinceLine = 130;
    EXPECT_EQ(healthOf(status).badge, "STALE 2 min");
    status.connection.phase = scanner::ConnectionPhase::Lost;
    status.secondsSinceLine = 7300;
    EXPECT_EQ(healthOf(status).badge, "LOST 2 h");
    status.connection.phase = scanner::ConnectionPhase::Stopped;
    EXPECT_EQ(healthOf(status).badge, "STOPPED");
}

// All lines of a sweep came: nothing is wrong, because the scanner has nothing more to send.
TEST(LiveHealth, AfterTheLastLineNothingIsLost) {
    LiveStatus status;
    status.connection = {scanner::ConnectionPhase::Lost, "x:2112: disconnected. Check the cable.", {}};
    status.secondsSinceLine = 42;
    status.lines = 40;
    status.sweep.expected = 40;
    status.sweep.lines = status.sweep.received = 39;
    EXPECT_EQ(healthOf(status).badge, "LOST 42 s");
    EXPECT_TRUE(healthOf(status).stale());
    status.sweep.lines = status.sweep.received = 40;
    for (const auto phase : {scanner::ConnectionPhase::Lost, scanner::ConnectionPhase::Stale, scanner::ConnectionPhase::Live}) {
        status.connection.phase = phase;
        const LiveHealth health = healthOf(status);
        EXPECT_EQ(health.badge, "STOPPED 42 s");
        EXPECT_EQ(health.end, "sweep complete");
        EXPECT_FALSE(health.stale());
        EXPECT_EQ(health.sentence,
                  phase == scanner::ConnectionPhase::Lost ? status.connection.sentence : "The sweep has ended; no line has come since.");
    }
    status.connection.phase = scanner::ConnectionPhase::Live;
    status.secondsSinceLine = 0.1;
    EXPECT_EQ(healthOf(status).badge, "LIVE");
}

TEST(LiveHealth, ThePictureIsNeverOlderThanItSays) {
    LiveStatus status;
    status.connection.phase = scanner::ConnectionPhase::Live;
    status.secondsSinceLine = 0.1;
    status.lines = 312;
    status.sweep.lines = status.sweep.received = 312;
    status.sweep.newestNs = 9'000'000'000;
    status.sweep.growing = true;
    scanner::SweepProgress shown = status.sweep;
    shown.lines = shown.received = 280;
    shown.newestNs -= 1'800'000'000;
    EXPECT_EQ(healthOf(status, nullptr, &shown).badge, "LIVE");
    EXPECT_EQ(healthOf(status, nullptr, &shown).lines, "280 lines") << "how many the sweep has is not known";
    status.secondsSinceLine = 0.3; // no other line came meanwhile: the picture is 2.1 s old, the newest line is not
    EXPECT_EQ(healthOf(status).badge, "LIVE");
    EXPECT_EQ(healthOf(status, nullptr, &shown).badge, "STALE 2 s");
    EXPECT_TRUE(healthOf(status, nullptr, &shown).stale());
}

TEST(LiveHealth, ReportsLinesLossesWindowPoseEndAndRecording) {
    LiveStatus status;
    status.connection.phase = scanner::ConnectionPhase::Live;
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
    LiveStatus normal = status; // more lines come: nothing is incomplete yet, and the lost lines are named
    normal.sweep.growing = true;
    EXPECT_EQ(healthOf(normal).lines, "312/1000 lines");
    EXPECT_EQ(healthOf(normal).lost, "3 lost: lines 5, 9 to 10");
    normal.sweep.received = 312;
    normal.sweep.lost.clear();
    EXPECT_EQ(healthOf(normal).lines, "312/1000 lines");
    normal.connection.phase = scanner::ConnectionPhase::Stopped;
    EXPECT_EQ(healthOf(normal).lines, "INCOMPLETE 312/1000 lines");
    EXPECT_EQ(health.noReturn, "no return 4.2 %");
    EXPECT_EQ(health.end, "28 s left");
    LiveStatus next = status; // has begun, while the picture is of the end of the sweep before: "599/600 lines, 30 s left"
    next.sweep.number = status.sweep.number + 1;
    EXPECT_EQ(healthOf(next).end, "28 s left");
    EXPECT_EQ(healthOf(next, nullptr, &status.sweep).end, "");
    LiveStatus joined = status; // in the middle of a sweep
    joined.sweep.startAssumed = "The first line received is taken as line 0 of the sweep.";
    joined.sweep.endUnknown = true;
    EXPECT_EQ(healthOf(joined).end, "");
    EXPECT_EQ(healthOf(joined).remark, "START ASSUMED");
    EXPECT_EQ(healthOf(joined).telegrams, Condition::OutOfSpec);
    status.connection.phase = scanner::ConnectionPhase::Lost; // no lines arrive: the time of the last one is unknown
    EXPECT_EQ(healthOf(status).end, "");
    status.connection.phase = scanner::ConnectionPhase::Live;
    status.secondsSinceLine = 5.0;
    EXPECT_EQ(healthOf(status).end, "");
    EXPECT_EQ(healthOf(status).contamination, "window clean, 5 s ago"); // nothing is known of the present
    status.secondsSinceLine = 0.0;
    EXPECT_EQ(health.contamination, "window clean");
    EXPECT_EQ(health.pose, ""); // the status line has it
    EXPECT_TRUE(health.recording.empty());
    // S5: stored for the sweep even after it is cleared.
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
    EXPECT_EQ(healthOf(status).end, "sweep complete");
    EXPECT_EQ(healthOf(status).lines, "1000/1000 lines");
}

TEST(LiveHealth, ReportsFaultsOfTheTelegrams) {
    LiveStatus status;
    status.connection.phase = scanner::ConnectionPhase::Live;
    status.secondsSinceLine = 0.0;
    status.lines = status.sweep.lines = status.sweep.received = status.sweep.expected = 40;
    EXPECT_EQ(healthOf(status).remark, "");
    EXPECT_EQ(healthOf(status).end, "sweep complete");
    status.sweep.irregular.note(scanner::Irregularity::ClockJump, 7);
    EXPECT_EQ(healthOf(status).remark, "1 remark");
    EXPECT_EQ(healthOf(status).telegrams, Condition::OutOfSpec);
    EXPECT_EQ(healthOf(status).end, "sweep complete");
    status.undecodable = 2;
    EXPECT_EQ(healthOf(status).remark, "2 remarks");
    const std::string axis = "the axis (spin)",
                      step = "the step from line to line (0.18 degrees, the motor turning on while a line is measured)";
    const std::string seen = "the axis (sweep" + std::string(kAxisFromRanges), first = std::string(kFirstAssumed) + "-90 degrees)";
    for (const auto& [what, badge, assumed] :
         {std::tuple(axis, "MOUNTING ASSUMED", Assumed::Mounting), std::tuple(axis + ", " + step, "MOUNTING ASSUMED", Assumed::Mounting),
          std::tuple(seen, "MOUNTING FROM RANGES", Assumed::SeenAxis), std::tuple(seen + ", " + step, "STEP ASSUMED 0.18°", Assumed::Step),
          std::tuple(step, "STEP ASSUMED 0.18°", Assumed::Step), std::tuple(first, "FIRST ANGLE ASSUMED", Assumed::Direction),
          std::tuple(seen + ", " + first, "MOUNTING FROM RANGES", Assumed::SeenAxis)}) {
        status.sweep.assumed = kMountingAssumed + what + ". Give it where that is wrong.";
        EXPECT_EQ(healthOf(status).remark, badge);
        EXPECT_EQ(assumedIn(status.sweep.assumed), assumed);
    }
    status.sweep.assumed.clear();
    EXPECT_NE(healthOf(status).remarks.at(0).find("(line 7)"), std::string::npos) << healthOf(status).remarks.at(0);
    status.sweep.irregular.note(scanner::Irregularity::CounterJump, 9, 3);
    EXPECT_EQ(healthOf(status).remark, "COUNTERS IN DOUBT");
    EXPECT_EQ(healthOf(status).lines, "40/40 lines, COUNTERS IN DOUBT");
    EXPECT_EQ(healthOf(status).end, "sweep ended");
}

// One or two lines after the connection say nothing about the rate, and so about the time that is left.
TEST(LiveFeed, TheRateIsNotKnownFromAFewLines) {
    scanner::EmulatedScannerSettings settings;
    settings.linesPerSecond = 50;
    settings.atEnd = scanner::AtEnd::Stop;
    const auto scanner = served(countingScan(8, 30), settings);
    scanner::SweepSettings sweep;
    sweep.expectedLines = 80;
    LiveFeed feed(settingsFor(*scanner), sweep, [] {});
    ASSERT_TRUE(waitUntil([&] { return feed.status().lines >= 8; }));
    EXPECT_EQ(feed.status().linesPerSecond, 0.0);
    EXPECT_EQ(healthOf(feed.status()).end, "");
}

TEST(LiveFeed, ARecordingBegunLateHoldsTheSweepFromItsBeginning) {
    scanner::EmulatedScannerSettings settings;
    settings.linesPerSecond = 300;
    settings.atEnd = scanner::AtEnd::Again;
    const Scan scan = countingScan(80, 30);
    const auto scanner = served(scan, settings);
    scanner::SweepSettings sweep;
    sweep.expectedLines = 80;
    const Folder folder;
    {
        LiveFeed feed(settingsFor(*scanner), sweep, [] {});
        // In the middle of the second sweep.
        ASSERT_TRUE(waitUntil([&] { return feed.status().lines >= 110; }));
        const auto started = feed.startRecording(folder / "late.mcap");
        ASSERT_TRUE(started);
        EXPECT_GE(*started, 30); // of the second sweep
        EXPECT_LE(*started, 80);
        EXPECT_FALSE(feed.startRecording(folder / "again.mcap"));
        ASSERT_TRUE(waitUntil([&] { return feed.status().lines >= 165; }));
        EXPECT_NEAR(feed.status().linesPerSecond, 300, 150);
        ASSERT_TRUE(feed.stopRecording());
    }
    const auto recording = Recording::open(folder / "late.mcap");
    ASSERT_TRUE(recording) << recording.error().sentence();
    const auto opened = scanOf(*recording, "late.mcap");
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
