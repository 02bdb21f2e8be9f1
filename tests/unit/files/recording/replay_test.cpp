// Recordings opened, played and saved: every way gives the same scan.
#include "app/lab/sim/simulate.h"
#include "core/files/open_save/open_scan.h"
#include "core/files/open_save/save_scan.h"
#include "core/files/recording/replay.h"
#include "core/files/recording/save_recording.h"
#include "core/scan/grid/assumed_mounting.h"
#include "tests/support/live_lines.h"
#include "tests/support/point_lists.h"
#include "tests/support/ros_sweeps.h"
#include "tests/support/run_program.h"
#include "tests/support/scans.h"
#include "tests/support/shared_folder.h"

#include <gtest/gtest.h>

#include <chrono>
#include <ctime>
#include <random>

using namespace edgescan;
using namespace edgescan::files;
using namespace edgescan::test;

namespace {

const std::string kDemo = (edgescan::test::sharedFolder() / "protocol/vectors/sweep_demo.mcap").string();

bool warns(const Scan& scan, const std::string& words) {
    return std::any_of(scan.warnings.begin(), scan.warnings.end(),
                       [&](const std::string& w) { return w.find(words) != std::string::npos; });
}

/// A recording of `lines` lines with the stepper's reports, some lost.
Bytes sampleRecording(int lines, int beams = 61) {
    scanner::SweepSettings settings;
    settings.expectedLines = lines;
    std::vector<RecordingMessagePtr> messages;
    for (int n = 0; n < lines; ++n) {
        if (n % 13 != 12) messages.push_back(lineMessage(n, {.beams = beams}));
        messages.push_back(stepperMessage({n, 2 + 0.17 * n, 4.25, true, hostNsOfLine(n)}));
    }
    return recordingBytes(scanner::metadataOf(settings), messages);
}

std::shared_ptr<const Recording> recordingOfBytes(Bytes bytes) {
    auto recording = Recording::fromBytes(std::move(bytes), "test");
    EXPECT_TRUE(recording);
    return *recording;
}

/// Saved as a recording and opened again: the same in everything relevant.
void expectRoundTrip(const Scan& scan) {
    const Folder folder;
    const auto saved = saveScan(scan, folder / "a.mcap");
    ASSERT_TRUE(saved) << saved.error().sentence();
    const auto opened = openScan(folder / "a.mcap");
    ASSERT_TRUE(opened) << opened.error().sentence();
    EXPECT_EQ(opened->state, scan.state);
    EXPECT_EQ(std::get<PolarGeometry>(opened->geometry), std::get<PolarGeometry>(scan.geometry));
    ASSERT_EQ(opened->cells(), scan.cells());
    for (std::size_t k = 0; k < scan.cells(); ++k) {
        if (scan.state[k] == CellState::Valid || scan.state[k] == CellState::DeviceStatus) {
            ASSERT_EQ(opened->rangeMm[k], scan.rangeMm[k]) << k;
        }
    }
    EXPECT_EQ(opened->note, scan.note);
}

double threadMs() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

} // namespace

TEST(Replay, AnySpeedAndOrderGivesWhatTheFileGives) {
    const Folder folder;
    const Bytes bytes = sampleRecording(90);
    writeText(folder / "a.mcap", std::string(bytes.begin(), bytes.end()));
    const auto opened = openScan(folder / "a.mcap");
    ASSERT_TRUE(opened) << opened.error().sentence();
    EXPECT_EQ(opened->lines(), 90);
    EXPECT_EQ(opened->name, "a");
    EXPECT_TRUE(warns(*opened, "INCOMPLETE 84/90 lines"));
    const auto recording = recordingOfBytes(bytes);
    Replay byLine(recording);
    EXPECT_EQ(byLine.lines(), 84);
    while (byLine.step()) EXPECT_EQ(byLine.progress().received, byLine.position());
    EXPECT_TRUE(byLine.atEnd());
    EXPECT_TRUE(sameScan(*byLine.snapshot(), *opened));
    std::mt19937 random(6);
    Replay scrubbed(recording);
    for (int i = 0; i < 40; ++i) {
        const int line = static_cast<int>(random() % 84);
        scrubbed.seek(line);
        EXPECT_EQ(scrubbed.position(), line);
        Replay fresh(recording);
        for (int n = 0; n < line; ++n) fresh.step();
        if (line == 0) continue;
        EXPECT_TRUE(sameScan(*scrubbed.snapshot(), *fresh.snapshot())) << line;
    }
    scrubbed.seek(scrubbed.lines());
    EXPECT_TRUE(sameScan(*scrubbed.snapshot(), *opened));
    Replay copy = scrubbed;
    copy.seek(10);
    EXPECT_EQ(scrubbed.position(), 84);
}

TEST(Replay, TheDemoOpensWithItsAngles) {
    EDGESCAN_NEEDS_SHARED("protocol/vectors");
    const auto scan = openScan(kDemo);
    ASSERT_TRUE(scan) << scan.error().sentence();
    EXPECT_EQ(scan->lines(), 24);
    EXPECT_EQ(scan->beams(), 1141);
    EXPECT_EQ(scan->format, "recording");
    EXPECT_TRUE(scan->warnings.empty());
    const auto& polar = std::get<PolarGeometry>(scan->geometry);
    EXPECT_EQ(polar.axis, Axis::Spin);
    EXPECT_DOUBLE_EQ(polar.beamDeg.front(), -5.0);
    EXPECT_DOUBLE_EQ(polar.beamDeg.back(), 185.0);
    for (int row = 0; row < 24; ++row) EXPECT_NEAR(polar.lineDeg[std::size_t(row)], 0.18 * row, 1e-9);
    // 0.095 degrees along the line, plus the 0.07 between stamp and first beam.
    EXPECT_NEAR(polar.lineSkewDeg.front(), 0.0695, 1e-3);
    EXPECT_NEAR(polar.lineSkewDeg.back() - polar.lineSkewDeg.front(), 0.095, 1e-3);
    const Folder folder;
    ASSERT_TRUE(saveScan(*scan, folder / "again.mcap"));
    const auto again = openScan(folder / "again.mcap");
    ASSERT_TRUE(again);
    EXPECT_TRUE(sameScan(*again, *scan));
}

TEST(Replay, ACutRecordingIsIncompleteWithEverythingUpToTheCut) {
    const Bytes bytes = sampleRecording(100);
    const auto whole = scanOf(recordingOfBytes(bytes), "test");
    ASSERT_TRUE(whole);
    std::mt19937 random(7);
    const Folder folder;
    int opened = 0;
    for (int round = 0; round < 60; ++round) {
        const auto cut = static_cast<std::ptrdiff_t>(3000 + random() % (bytes.size() - 4000));
        writeText(folder / "cut.mcap", std::string(bytes.begin(), bytes.begin() + cut));
        const auto scan = openScan(folder / "cut.mcap");
        if (!scan) {
            EXPECT_NE(scan.error().sentence().find("no scan telegram"), std::string::npos) << scan.error().sentence();
            continue;
        }
        ++opened;
        EXPECT_TRUE(warns(*scan, "cut off"));
        EXPECT_TRUE(scan->lines() == 100 || warns(*scan, "/100 lines"));
        EXPECT_TRUE(warns(*scan, "INCOMPLETE"));
        for (int row = 0; row < scan->lines(); ++row) {
            EXPECT_TRUE(std::equal(scan->rangeMm.line(row), scan->rangeMm.line(row) + scan->beams(), whole->rangeMm.line(row)));
            EXPECT_TRUE(std::equal(scan->state.line(row), scan->state.line(row) + scan->beams(), whole->state.line(row)));
        }
    }
    EXPECT_GT(opened, 0);
}

TEST(Replay, DamagedRecordingsNeverCrash) {
    const Bytes bytes = sampleRecording(60, 31);
    std::mt19937 random(12);
    const Folder folder;
    int opened = 0;
    for (int round = 0; round < 500; ++round) {
        Bytes damaged = bytes;
        for (auto flips = 1 + random() % 30; flips > 0; --flips) damaged[random() % damaged.size()] = static_cast<std::uint8_t>(random());
        if (round % 3 == 0) damaged.resize(random() % damaged.size());
        const auto recording = Recording::fromBytes(damaged, "test");
        if (!recording) continue;
        const auto scan = scanOf(*recording, "test");
        if (!scan) continue;
        ++opened;
        std::size_t sum = 0;
        for (const std::size_t count : countCells(*scan)) sum += count;
        EXPECT_EQ(sum, scan->cells());
        for (const double angle : std::get<PolarGeometry>(scan->geometry).lineDeg) EXPECT_TRUE(std::isfinite(angle));
    }
    EXPECT_GT(opened, 0);
}

// Telegrams may contain anything: a chunk with a correct CRC can hold invalid ones.
TEST(Replay, HostileTelegramsNeverCrash) {
    std::mt19937 random(13);
    int opened = 0;
    for (int round = 0; round < 150; ++round) {
        std::vector<RecordingMessagePtr> messages;
        for (int n = 0; n < 30; ++n) {
            scanner::ScanTelegram telegram = telegramOfLine(n, {.beams = 12});
            if (random() % 4 == 0) telegram.telegramCounter = static_cast<std::uint16_t>(random());
            if (random() % 4 == 0) telegram.scanCounter = static_cast<std::uint16_t>(random());
            if (random() % 4 == 0) telegram.sinceStartUs = static_cast<std::uint32_t>(random());
            if (random() % 8 == 0) telegram.transmittedUs = static_cast<std::uint32_t>(random());
            if (random() % 8 == 0) telegram.scanFrequency = static_cast<std::uint32_t>(random());
            if (random() % 8 == 0) telegram.encoders = {{static_cast<std::uint32_t>(random()), 0}};
            if (random() % 6 == 0) telegram.channels16[0].startAngle = static_cast<std::int32_t>(random());
            if (random() % 6 == 0) telegram.channels16[0].step = static_cast<std::uint16_t>(random());
            if (random() % 6 == 0) telegram.channels16[0].scale = static_cast<float>(random()) * 1e30F;
            if (random() % 6 == 0) telegram.channels16[0].values.resize(random() % 40);
            RecordingMessage message{RecordingTopic::ColaRx, hostNsOfLine(n),
                                     scanner::framed(scanner::encodeScanTelegram(telegram, scanner::Dialect::B), scanner::Dialect::B)};
            if (random() % 6 == 0) message.hostNs = static_cast<std::int64_t>((static_cast<std::uint64_t>(random()) << 31U) ^ random());
            if (random() % 9 == 0) message.hostNs = INT64_MAX;
            messages.push_back(std::make_shared<const RecordingMessage>(message));
            if (random() % 4 == 0) messages.push_back(stepperMessage({n, static_cast<double>(random()) / 4, 1e5, true, hostNsOfLine(n)}));
        }
        scanner::SweepSettings settings;
        if (random() % 2 == 0) settings.ticksPerDeg = 1e-3;
        const auto scan = scanOf(recordingOfBytes(recordingBytes(scanner::metadataOf(settings), messages)), "test");
        if (!scan) continue;
        ++opened;
        for (const double angle : std::get<PolarGeometry>(scan->geometry).lineDeg) EXPECT_TRUE(std::isfinite(angle));
    }
    EXPECT_GT(opened, 0);
}

TEST(Replay, TheBagOfATurnedLaserIsPlayedInTheOrderOfTime) {
    Scan scan = boxesScan(60, 80, 3, 0.05);
    auto& polar = std::get<PolarGeometry>(scan.geometry);
    polar.axis = Axis::Sweep;
    for (int i = 0; i < 60; ++i) polar.lineDeg[static_cast<std::size_t>(i)] = -20 + 0.5 * i;
    for (const AngleFrom from : {AngleFrom::Transform, AngleFrom::Joint}) {
        const TemporaryFolder folder;
        const Bytes bytes = mcapOf(rosMessagesOf(scan, {.from = from, .wire = Wire::CdrLittle}));
        writeText(folder / "bag.mcap", std::string(bytes.begin(), bytes.end()));
        const auto recording = Recording::open(folder / "bag.mcap");
        ASSERT_TRUE(recording) << recording.error().sentence();
        Replay replay(*recording);
        ASSERT_EQ(replay.lines(), 60);
        replay.seek(replay.lines());
        ASSERT_TRUE(replay.snapshot());
        EXPECT_EQ(replay.snapshot()->lines(), 60);
        EXPECT_EQ(replay.snapshot()->rangeMm, scan.rangeMm);
        replay.seek(58); // a joint is believed after two seconds without a transform
        ASSERT_TRUE(replay.snapshot());
        EXPECT_EQ(replay.snapshot()->lines(), 58);
    }
}

TEST(Replay, TheLongestOfSeveralSweepsIsOpened) {
    std::vector<RecordingMessagePtr> messages;
    for (int n = 0; n < 100; ++n) {
        const double phi = n < 30 ? 0.2 * n : 0.2 * (60 - n); // reverses after 30 lines
        messages.push_back(lineMessage(n));
        messages.push_back(stepperMessage({n, phi, n < 30 ? 5.0 : -5.0, true, hostNsOfLine(n)}));
    }
    const auto scan = scanOf(recordingOfBytes(recordingBytes(scanner::metadataOf({}), messages)), "test");
    ASSERT_TRUE(scan);
    EXPECT_EQ(scan->lines(), 69);
    EXPECT_TRUE(warns(*scan, "2 sweeps; sweep 2"));
}

// A sweep that was recorded as spin without an angle of its first line: read as a nodding one it begins where a live one does, and says so.
TEST(Replay, AnotherAxisAssumesTheFirstAngleOfThatAxis) {
    scanner::SweepSettings settings;
    settings.axis = Axis::Spin;
    settings.expectedLines = 60;
    settings.degPerLine = 3.0;
    settings.firstAssumed = true;
    std::vector<RecordingMessagePtr> messages;
    for (int n = 0; n < 60; ++n) messages.push_back(lineMessage(n));
    const auto recording = recordingOfBytes(recordingBytes(scanner::metadataOf(settings), messages));
    const auto firstOf = [](const Scan& scan) { return std::get<PolarGeometry>(scan.geometry).lineDeg.front(); };
    const auto spin = scanOf(recording, "test");
    ASSERT_TRUE(spin);
    EXPECT_EQ(firstOf(*spin), 0.0);
    ReadingOptions options;
    options.axis = Axis::Sweep;
    const auto nodding = scanOf(recording, "test", options);
    ASSERT_TRUE(nodding);
    EXPECT_EQ(std::get<PolarGeometry>(nodding->geometry).axis, Axis::Sweep);
    EXPECT_EQ(firstOf(*nodding), -90.0);
    EXPECT_TRUE(assumedIn(*nodding) == Assumed::Direction);
    options.lineStartDeg = -45.0;
    const auto given = scanOf(recording, "test", options);
    ASSERT_TRUE(given);
    EXPECT_EQ(firstOf(*given), -45.0);
    EXPECT_TRUE(assumedIn(*given) == Assumed::Nothing);
}

TEST(Replay, AFirstAngleThatTheRecordingLeavesOutIsMarkedUnlessASpinIsGiven) {
    std::vector<RecordingMessagePtr> messages;
    for (int n = 0; n < 60; ++n) messages.push_back(lineMessage(n));
    const auto opened = [&](const char* axis, const ReadingOptions& options) {
        const scanner::SweepMetadata said{
            {"format", "sweep/1"}, {"stepper.axis", axis}, {"stepper.deg_per_step", "3"}, {"sweep.lines", "60"}};
        const auto scan = scanOf(recordingOfBytes(recordingBytes(said, messages)), "test", options);
        EXPECT_TRUE(scan);
        return std::pair(std::get<PolarGeometry>(scan->geometry).lineDeg.front(), assumedIn(*scan));
    };
    EXPECT_EQ(opened("[1,0,0]", {}), std::pair(-90.0, Assumed::Direction));
    EXPECT_EQ(opened("[0,0,1]", {}), std::pair(0.0, Assumed::Nothing));
    ReadingOptions spin;
    spin.axis = Axis::Spin;
    EXPECT_EQ(opened("[1,0,0]", spin), std::pair(0.0, Assumed::Nothing));
}

TEST(Replay, NoScanIsOneSentence) {
    const Folder folder;
    const Bytes empty = recordingBytes(scanner::metadataOf({}), {});
    writeText(folder / "empty.mcap", std::string(empty.begin(), empty.end()));
    containers::McapEncoder other("other");
    other.channel({1, 0, "/camera", "json", {}});
    other.message({1, 0, 1, 1, Bytes(3, '1')});
    other.finish();
    const Bytes foreign = other.popBytes();
    writeText(folder / "foreign.mcap", std::string(foreign.begin(), foreign.end()));
    writeText(folder / "magic.mcap", std::string(containers::kMcapMagic));
    for (const char* name : {"empty.mcap", "foreign.mcap", "magic.mcap"}) {
        const auto scan = openScan(folder / name);
        ASSERT_FALSE(scan) << name;
        EXPECT_NE(scan.error().sentence().find(name), std::string::npos) << scan.error().sentence();
    }
}

TEST(SaveRecording, ScansOfEveryKindSurvive) {
    for (unsigned seed = 1; seed < 25; ++seed) {
        Scan scan = makeScan({.axis = seed % 2 == 0 ? Axis::Spin : Axis::Sweep,
                              .lines = 1 + static_cast<int>(seed * 3 % 40),
                              .beams = 1 + static_cast<int>(seed * 7 % 50),
                              .beamStep = seed % 3 == 0 ? -0.5 : 1.0 / 6,
                              .motorJitter = seed % 4 == 0 ? 0.7 : 0.0,
                              .seed = seed});
        auto& polar = std::get<PolarGeometry>(scan.geometry);
        if (seed % 5 == 0) polar.lineDirection = -1;
        if (seed % 5 == 1) polar.lineSkewDeg.assign(polar.beamDeg.size(), 0.03 * seed);
        if (seed % 6 == 0) scan.note = "what the file \"said\"\nin two lines";
        std::mt19937 random(seed);
        for (int run = 0; run < 6 && seed % 2 == 0; ++run) { // lost, masked, out of window, status
            const CellState states[] = {CellState::Lost, CellState::Masked, CellState::OutOfWindow};
            const CellState state = states[random() % 3];
            const std::size_t first = random() % scan.cells();
            for (std::size_t k = first; k < std::min(scan.cells(), first + 80); ++k) scan.state[k] = state;
        }
        if (seed % 7 == 0) {
            scan.statusCodes = {32759};
            scan.rangeMm[0] = 32759;
            scan.state[0] = CellState::DeviceStatus;
        }
        SCOPED_TRACE(seed);
        expectRoundTrip(scan);
        if (HasFatalFailure()) return;
    }
}

TEST(SaveRecording, ASimulatedBellSurvives) {
    sim::SimulationSettings settings;
    settings.lines = 60;
    settings.beams = 90;
    settings.rocks = 40;
    const auto simulation = sim::simulate(settings);
    ASSERT_TRUE(simulation);
    expectRoundTrip(simulation->scan);
}

TEST(SaveRecording, LostLinesAreLeftOutAndUnitsKept) {
    Scan scan = makeScan({.lines = 30, .beams = 40});
    scan.unitMm = 0.5;
    for (float& range : scan.rangeMm.cells) range += 0.5F;
    for (int line = 7; line < 12; ++line) std::fill(scan.state.line(line), scan.state.line(line) + 40, CellState::Lost);
    expectRoundTrip(scan);
    const auto bytes = recordingOf(scan, "test");
    ASSERT_TRUE(bytes);
    EXPECT_EQ(Replay(recordingOfBytes(*bytes)).lines(), 25);
    EXPECT_EQ(*bytes, *recordingOf(scan, "other")) << "the same scan gives the same bytes";
}

TEST(SaveRecording, WhatTelegramsCannotCarryIsRefused) {
    const Folder folder;
    Scan scan = makeScan({.lines = 5, .beams = 9});
    writeText(folder / "a.mcap", "old");
    for (const float range : {1234.5F, 70000.0F}) {
        Scan odd = scan;
        odd.rangeMm[12] = range;
        odd.state[12] = CellState::Valid;
        const auto saved = saveScan(odd, folder / "a.mcap");
        ASSERT_FALSE(saved);
        EXPECT_NE(saved.error().sentence().find("line 1, beam 3"), std::string::npos) << saved.error().sentence();
    }
    scan.geometry = PointGeometry{Grid<Eigen::Vector3d>(5, 9, Eigen::Vector3d::Zero().eval()), Eigen::Vector3d::Zero()};
    EXPECT_FALSE(saveScan(scan, folder / "a.mcap"));
    EXPECT_EQ(readText(folder / "a.mcap"), "old");
}

TEST(Sweep, CostOfALineAndOfASnapshot) {
    constexpr int kLines = 1000;
    scanner::SweepSettings settings;
    settings.expectedLines = kLines;
    std::vector<scanner::ColaFrame> frames;
    for (int n = 0; n < kLines; ++n) {
        const Bytes wire =
            scanner::framed(scanner::encodeScanTelegram(telegramOfLine(n, {.beams = 1141}), scanner::Dialect::B), scanner::Dialect::B);
        frames.push_back(scanner::ColaStream().push(wire).front());
    }
    scanner::SweepFeed feed(settings);
    double worst = 0;
    double sum = 0;
    double lineMs = 0;
    std::shared_ptr<const Scan> shown, worked; // two readers hold their scans
    for (int n = 0; n < kLines; ++n) {
        const double start = threadMs();
        feed.frame(frames[static_cast<std::size_t>(n)], hostNsOfLine(n));
        const double middle = threadMs();
        auto now = feed.assembler().snapshot();
        const double snapshotMs = threadMs() - middle;
        lineMs += middle - start;
        sum += snapshotMs;
        if (n > 4) worst = std::max(worst, snapshotMs);
        worked = shown;
        shown = std::move(now);
    }
    EXPECT_EQ(shown->lines(), kLines);
    std::printf(
        "[ measured ] 1141 beams: line %.0f us from frame to row, snapshot of up to 1000 lines %.0f us, at worst %.2f ms (thread CPU)\n",
        1e3 * lineMs / kLines, 1e3 * sum / kLines, worst);
    EXPECT_LT(sum / kLines, 2.0);
}
