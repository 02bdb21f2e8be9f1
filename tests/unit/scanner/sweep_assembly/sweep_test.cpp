// Sweep assembly: every telegram is in its row, every lost one is reported, nothing is invented.
#include "tests/support/cola_vectors.h"
#include "tests/support/live_lines.h"

#include <gtest/gtest.h>

#include <fstream>
#include <random>
#include <set>

using namespace edgescan;
using namespace edgescan::scanner;
using namespace edgescan::test;

namespace {

SweepAssembler assembled(const SweepSettings& settings, int lines, const std::set<int>& dropped, const LineStyle& style = {}) {
    SweepAssembler assembler(settings);
    for (int n = 0; n < lines; ++n) {
        if (!dropped.contains(n)) pushTelegram(assembler, telegramOfLine(n, style), hostNsOfLine(n));
    }
    return assembler;
}

void expectRows(SweepAssembler& assembler, const std::set<int>& dropped) {
    const auto scan = assembler.snapshot();
    const SweepProgress progress = assembler.progress();
    ASSERT_TRUE(scan);
    EXPECT_TRUE(addsUp(*scan, progress));
    for (int row = 0; row < scan->lines(); ++row)
        EXPECT_TRUE(dropped.contains(row) ? rowIsLost(*scan, row) : rowHolds(*scan, row, row)) << row;
    EXPECT_EQ(std::set<int>(progress.lost.begin(), progress.lost.end()), dropped);
}

bool warns(const Scan& scan, const std::string& words) {
    return std::any_of(scan.warnings.begin(), scan.warnings.end(),
                       [&](const std::string& w) { return w.find(words) != std::string::npos; });
}

constexpr const char* kFirstLine = "The first line received is taken as line 0 of the sweep.";

const PolarGeometry& polarOf(const Scan& scan) { return std::get<PolarGeometry>(scan.geometry); }

} // namespace

TEST(Sweep, LinesAndStepsFromTheConfiguredStart) {
    SweepSettings settings;
    settings.firstLineDeg = -20;
    settings.expectedLines = 50;
    SweepAssembler assembler = assembled(settings, 50, {});
    expectRows(assembler, {});
    const auto scan = assembler.snapshot();
    EXPECT_EQ(assembler.progress().text(), "50/50 lines");
    EXPECT_EQ(scan->warnings.size(), 1U);
    EXPECT_TRUE(warns(*scan, kFirstLine)) << "the angles are counted, and the stepper may have been turning before";
    for (int row = 0; row < 50; ++row) EXPECT_DOUBLE_EQ(polarOf(*scan).lineDeg[std::size_t(row)], -20 + 0.18 * row);
    EXPECT_DOUBLE_EQ(polarOf(*scan).beamDeg.back(), -5 + 60.0 / 6);
    EXPECT_EQ(assembler.snapshot(), scan) << "nothing changed, so it is the same";
}

TEST(Sweep, EveryFiftiethABurstAndTheLastHundredAreReported) {
    std::set<int> dropped;
    for (int n = 49; n < 500; n += 50) dropped.insert(n);
    for (int n = 210; n < 240; ++n) dropped.insert(n);
    SweepSettings settings;
    settings.expectedLines = 600;
    SweepAssembler assembler = assembled(settings, 500, dropped, {.beams = 21}); // the last hundred never arrive
    std::set<int> told = dropped;
    told.erase(499); // no telegram arrived after it: its loss is unknown
    expectRows(assembler, told);
    const SweepProgress progress = assembler.progress();
    EXPECT_EQ(progress.lines, 499);
    EXPECT_EQ(progress.text(), "INCOMPLETE 460/600 lines");
    EXPECT_TRUE(warns(*assembler.snapshot(), "INCOMPLETE 460/600 lines"));
    EXPECT_TRUE(warns(*assembler.snapshot(), "49, 99, 149, 199, 210 to 239"));
}

// A connection in the middle of a sweep: the stepper goes back to its start, and the lines after it are another sweep, not the same wall
// twice. The encoder has no scale, so its leap alone says it.
TEST(Sweep, AnEncoderThatLeapsBackBeginsANewSweep) {
    SweepSettings settings;
    settings.expectedLines = 60;
    SweepAssembler assembler(settings);
    for (int n = 0; n < 80; ++n) {
        if (n == 20) {
            EXPECT_EQ(assembler.progress().startAssumed, kFirstLine);
            EXPECT_TRUE(assembler.progress().endUnknown) << "40 lines are to come by the count, 5 by the encoder";
        }
        ScanTelegram telegram = telegramOfLine(n, {});
        telegram.encoders = {{static_cast<std::uint32_t>(4'294'967'000U + static_cast<unsigned>((n < 25 ? n + 35 : n - 25) * 77)), 0}};
        pushTelegram(assembler, telegram, hostNsOfLine(n));
    }
    auto finished = assembler.popFinished();
    ASSERT_EQ(finished.size(), 1U);
    EXPECT_EQ(finished[0].progress.text(), "INCOMPLETE 25/60 lines");
    EXPECT_TRUE(warns(*finished[0].scan, kFirstLine));
    EXPECT_EQ(assembler.progress().lines, 55);
    EXPECT_FALSE(warns(*assembler.snapshot(), kFirstLine)) << "the leap shows where this sweep begins";
    EXPECT_EQ(assembler.progress().startAssumed, "");
    EXPECT_FALSE(assembler.progress().endUnknown);
    EXPECT_TRUE(rowHolds(*assembler.snapshot(), 0, 25));
}

TEST(Sweep, CountersWrapWithoutFalseGaps) {
    for (const LineStyle style : {LineStyle{.beams = 11, .firstTelegram = 65400, .firstScan = 65500},
                                  LineStyle{.beams = 11, .firstTelegram = 65535, .firstUs = 4'294'000'000U}}) {
        SweepAssembler assembler = assembled({}, 300, {}, style);
        expectRows(assembler, {});
        EXPECT_EQ(assembler.progress().restarts, 0);
    }
}

TEST(Sweep, DuplicatesAreDroppedAndCounted) {
    SweepAssembler assembler;
    for (int n = 0; n < 40; ++n) {
        for (int copy = 0; copy <= n % 3; ++copy) pushTelegram(assembler, telegramOfLine(n), hostNsOfLine(n) + copy * 1000);
    }
    expectRows(assembler, {});
    EXPECT_EQ(assembler.progress().duplicates, 13 * 3);
}

TEST(Sweep, RandomLossesAndDuplicatesAlwaysAddUp) {
    std::mt19937 random(4);
    for (int round = 0; round < 60; ++round) {
        SweepAssembler assembler;
        std::set<int> dropped;
        int last = 0;
        for (int n = 0; n < 120; ++n) {
            if (n > 0 && random() % 4 == 0) continue;
            for (int row = last + 1; row < n; ++row) dropped.insert(row);
            last = n;
            pushTelegram(assembler, telegramOfLine(n, {.beams = 9}), hostNsOfLine(n));
            if (random() % 5 == 0) pushTelegram(assembler, telegramOfLine(n, {.beams = 9}), hostNsOfLine(n));
            if (n % 17 == 0) {
                ASSERT_TRUE(addsUp(*assembler.snapshot(), assembler.progress()));
            }
        }
        expectRows(assembler, dropped);
    }
}

TEST(Sweep, InterlacedLinesAreWovenIntoOneGrid) {
    for (const int firstHalf : {0, 1}) {
        SweepSettings settings;
        SweepAssembler assembler(settings);
        const auto half = [&](int n) {
            const bool odd = n % 2 == 1;
            return telegramOfLine(n, {.beams = odd ? 570 : 571, .startAngle = odd ? -48333 : -50000, .step = 3333, .frequency = 5000});
        };
        for (int n = firstHalf; n < 41; ++n) pushTelegram(assembler, half(n), kEpochNs + n * kPeriodNs / 2);
        assembler.finish();
        const auto scan = assembler.snapshot();
        ASSERT_EQ(scan->beams(), 1141);
        // A first line of the second kind belongs to a row whose beginning was not received.
        ASSERT_EQ(scan->lines(), firstHalf == 0 ? 21 : 20);
        const int offset = firstHalf == 0 ? 0 : 2;
        for (int row = 0; row < 20; ++row) {
            for (int beam = 0; beam < 1141; ++beam) {
                if (firstHalf == 1 && row == 19 && beam % 2 == 1) continue; // cut off
                ASSERT_EQ(scan->rangeMm.at(row, beam), rawOf(row * 2 + offset + beam % 2, beam / 2)) << row << ' ' << beam;
            }
        }
        EXPECT_NEAR(polarOf(*scan).beamDeg[1], -29.0 / 6, 1e-12);
        EXPECT_NEAR(polarOf(*scan).beamDeg.back(), 185.0, 1e-9);
        EXPECT_TRUE(addsUp(*scan, assembler.progress()));
        EXPECT_EQ(assembler.progress().lost, std::vector<int>{scan->lines() - 1}) << "half of it never came";
        // The second half of a line is measured one rotation of the mirror later.
        const auto& skew = polarOf(*scan).lineSkewDeg;
        ASSERT_EQ(skew.size(), 1141U);
        const double perTurn = 0.18 / 2;
        EXPECT_NEAR(skew[0], perTurn * 139.0 / 360, 1e-6);
        EXPECT_NEAR(skew[1], perTurn * (1 + (-29.0 / 6 + 144) / 360), 1e-6);
    }
}

TEST(Sweep, ALostHalfOfAnInterlacedLineIsLostAlone) {
    SweepAssembler assembler;
    for (int n = 0; n < 40; ++n) {
        if (n == 21) continue;
        const bool odd = n % 2 == 1;
        pushTelegram(assembler,
                     telegramOfLine(n, {.beams = odd ? 30 : 31, .startAngle = odd ? -48333 : -50000, .step = 3333, .frequency = 5000}),
                     kEpochNs + n * kPeriodNs / 2);
    }
    const auto scan = assembler.snapshot();
    ASSERT_EQ(scan->lines(), 20);
    EXPECT_EQ(assembler.progress().lost, std::vector<int>{10});
    for (int beam = 0; beam < 61; ++beam) EXPECT_EQ(scan->state.at(10, beam), beam % 2 == 1 ? CellState::Lost : CellState::Valid);
    EXPECT_TRUE(addsUp(*scan, assembler.progress()));
}

TEST(Sweep, FourfoldInterlacing) {
    SweepAssembler assembler;
    constexpr int kOrder[] = {0, 2, 1, 3}; // in an order that a device could use
    for (int n = 0; n < 48; ++n) {
        const int part = kOrder[n % 4];
        const int start = static_cast<int>(std::lround(-50000 + part * 10000.0 / 6));
        pushTelegram(assembler, telegramOfLine(n, {.beams = part == 0 ? 21 : 20, .startAngle = start, .step = 6667, .frequency = 10000}),
                     kEpochNs + n * kPeriodNs / 4);
    }
    const auto scan = assembler.snapshot();
    ASSERT_EQ(scan->beams(), 81);
    ASSERT_EQ(scan->lines(), 12);
    constexpr int kWhen[] = {0, 2, 1, 3};
    for (int row = 0; row < 12; ++row) {
        for (int beam = 0; beam < 81; ++beam) ASSERT_EQ(scan->rangeMm.at(row, beam), rawOf(row * 4 + kWhen[beam % 4], beam / 4));
    }
}

TEST(Sweep, EncoderCountsBecomeAnglesAndAReversalStartsTheNextSweep) {
    SweepSettings settings;
    settings.ticksPerDeg = 1000.0 / 0.18;
    settings.firstLineDeg = 3;
    SweepAssembler assembler(settings);
    const auto angleOf = [](int n) { return n < 100 ? n : 99 - (n - 99); }; // forward, then back
    for (int n = 0; n < 180; ++n) {
        ScanTelegram telegram = telegramOfLine(n);
        telegram.encoders = {{static_cast<std::uint32_t>(4'294'950'000U + static_cast<unsigned>(angleOf(n) * 1000)), 0}}; // wraps
        pushTelegram(assembler, telegram, hostNsOfLine(n));
    }
    assembler.finish();
    const auto sweeps = assembler.popFinished();
    ASSERT_EQ(sweeps.size(), 2U);
    ASSERT_EQ(sweeps[0].scan->lines(), 100);
    ASSERT_EQ(sweeps[1].scan->lines(), 80);
    for (int row = 0; row < 100; ++row) {
        EXPECT_TRUE(rowHolds(*sweeps[0].scan, row, row));
        EXPECT_NEAR(polarOf(*sweeps[0].scan).lineDeg[std::size_t(row)], 3 + 0.18 * row, 1e-9);
    }
    for (int row = 0; row < 80; ++row) {
        EXPECT_TRUE(rowHolds(*sweeps[1].scan, row, row + 100));
        EXPECT_NEAR(polarOf(*sweeps[1].scan).lineDeg[std::size_t(row)], 3 + 0.18 * (98 - row), 1e-9);
    }
    for (const FinishedSweep& sweep : sweeps) {
        EXPECT_TRUE(addsUp(*sweep.scan, sweep.progress));
        EXPECT_FALSE(warns(*sweep.scan, kFirstLine));
        EXPECT_TRUE(warns(*sweep.scan, "The encoder count of the first line received is taken as the first angle"));
    }
    // On the way back the beams of a line are in the opposite order.
    EXPECT_NEAR(polarOf(*sweeps[0].scan).lineSkewDeg[0], 0.18 * 139 / 360, 1e-6);
    EXPECT_NEAR(polarOf(*sweeps[1].scan).lineSkewDeg[0], -0.18 * 139 / 360, 1e-6);
}

TEST(Sweep, EncoderWithoutScaleIsReportedAndNotUsed) {
    SweepAssembler assembler;
    for (int n = 0; n < 10; ++n) {
        ScanTelegram telegram = telegramOfLine(n);
        telegram.encoders = {{static_cast<std::uint32_t>(n * 77), 0}};
        pushTelegram(assembler, telegram, hostNsOfLine(n));
    }
    EXPECT_EQ(assembler.progress().angleSource, AngleSource::Steps);
    EXPECT_TRUE(warns(*assembler.snapshot(), "encoder"));
}

TEST(Sweep, StepperReadingsLatchedWithTheirLines) {
    SweepAssembler assembler;
    std::mt19937 random(8);
    for (int n = 0; n < 60; ++n) {
        const StepperReading reading{n, 7 + 0.2 * n, 5.0, true, hostNsOfLine(n)};
        const bool before = random() % 2 == 0;
        if (before) assembler.push(reading);
        if (n != 30) pushTelegram(assembler, telegramOfLine(n), hostNsOfLine(n));
        if (!before) assembler.push(reading);
    }
    const auto scan = assembler.snapshot();
    for (int row = 0; row < 60; ++row) EXPECT_NEAR(polarOf(*scan).lineDeg[std::size_t(row)], 7 + 0.2 * row, 1e-9);
    EXPECT_NEAR(polarOf(*scan).lineSkewDeg[0], 5.0 * 0.04 * 139 / 360, 1e-9);
    EXPECT_EQ(assembler.progress().angleSource, AngleSource::Stepper);
    EXPECT_EQ(assembler.progress().startAssumed, "") << "the angles are measured";
    EXPECT_TRUE(assembler.progress().endUnknown) << "the stepper did not go back yet";
    EXPECT_TRUE(rowIsLost(*scan, 30));
}

TEST(Sweep, StepperReadingsAtTheirOwnTimes) {
    SweepAssembler assembler;
    const auto phiAt = [](std::int64_t ns) { return 4.5 * static_cast<double>(ns - kEpochNs) / 1e9; };
    std::int64_t nextReading = kEpochNs + 3'000'001;
    for (int n = 0; n < 100; ++n) {
        for (; nextReading < hostNsOfLine(n); nextReading += 17'000'000)
            assembler.push(StepperReading{0, phiAt(nextReading), 4.5, true, nextReading});
        pushTelegram(assembler, telegramOfLine(n), hostNsOfLine(n));
    }
    const auto scan = assembler.snapshot();
    // A line's stamp is its transmission time (40.6 ms) before its arrival.
    for (int row = 0; row < 100; ++row) EXPECT_NEAR(polarOf(*scan).lineDeg[std::size_t(row)], phiAt(hostNsOfLine(row) - 40'600'000), 1e-6);
}

TEST(Sweep, TimeAloneIsAVisibleWarning) {
    SweepSettings settings;
    settings.degPerLine.reset();
    settings.degPerSecond = 9;
    SweepAssembler assembler = assembled(settings, 20, {7});
    const auto scan = assembler.snapshot();
    EXPECT_TRUE(warns(*scan, "time alone"));
    for (int row = 0; row < 20; ++row) EXPECT_NEAR(polarOf(*scan).lineDeg[std::size_t(row)], 9 * 0.04 * row, 1e-9);
}

TEST(Sweep, ASweepOfUnknownLengthNamesNoLength) {
    SweepAssembler assembler = assembled({}, 40, {});
    EXPECT_EQ(assembler.progress().text(), "40 lines");
    EXPECT_EQ(assembler.progress().textSoFar(), "40 lines");
    EXPECT_EQ(assembled({}, 40, {7}).progress().text(), "INCOMPLETE 39/40 lines") << "of the lines that it has so far";
}

TEST(Sweep, SplitBySizeWithLinesLostAcrossTheEnd) {
    SweepSettings settings;
    settings.expectedLines = 25;
    SweepAssembler assembler = assembled(settings, 70, {22, 23, 24, 25, 26});
    assembler.finish();
    const auto sweeps = assembler.popFinished();
    ASSERT_EQ(sweeps.size(), 3U);
    EXPECT_EQ(sweeps[0].progress.text(), "INCOMPLETE 22/25 lines");
    EXPECT_EQ(sweeps[0].progress.lost, (std::vector<int>{22, 23, 24}));
    EXPECT_EQ(sweeps[1].progress.text(), "25/25 lines");
    EXPECT_TRUE(warns(*sweeps[1].scan, kFirstLine)) << "its start follows from that of the first";
    EXPECT_TRUE(rowHolds(*sweeps[1].scan, 0, 27));
    EXPECT_EQ(sweeps[2].progress.text(), "INCOMPLETE 18/25 lines");
}

TEST(Sweep, ScannerRestartedAfterAReconnect) {
    SweepAssembler assembler;
    for (int n = 0; n < 20; ++n) pushTelegram(assembler, telegramOfLine(n), hostNsOfLine(n));
    assembler.reconnected();
    for (int n = 0; n < 20; ++n) { // ten lines were missed in between
        ScanTelegram telegram = telegramOfLine(n, {.firstTelegram = 1, .firstScan = 1, .firstUs = 900'000});
        telegram.channels16[0].values = telegramOfLine(n + 30).channels16[0].values;
        pushTelegram(assembler, telegram, hostNsOfLine(n + 30));
    }
    std::set<int> lost;
    for (int row = 20; row < 30; ++row) lost.insert(row);
    expectRows(assembler, lost);
    EXPECT_EQ(assembler.progress().restarts, 1);
}

TEST(Sweep, ReconnectWithoutARestartKeepsCounting) {
    SweepAssembler assembler;
    for (int n = 0; n < 20; ++n) pushTelegram(assembler, telegramOfLine(n), hostNsOfLine(n));
    assembler.reconnected();
    for (int n = 45; n < 60; ++n) pushTelegram(assembler, telegramOfLine(n), hostNsOfLine(n));
    std::set<int> lost;
    for (int row = 20; row < 45; ++row) lost.insert(row);
    expectRows(assembler, lost);
    EXPECT_EQ(assembler.progress().restarts, 0);
}

TEST(Sweep, OneOddLineIsLostTwoAreAnotherScan) {
    SweepAssembler assembler;
    for (int n = 0; n < 40; ++n) pushTelegram(assembler, telegramOfLine(n, {.step = n == 25 ? 5000 : 1667}), hostNsOfLine(n));
    expectRows(assembler, {25});
    EXPECT_EQ(assembler.progress().misfits, 1);
    for (int n = 40; n < 50; ++n) pushTelegram(assembler, telegramOfLine(n, {.beams = 31, .step = 3333}), hostNsOfLine(n));
    EXPECT_EQ(assembler.snapshot()->beams(), 31);
    EXPECT_EQ(assembler.snapshot()->lines(), 10);
    EXPECT_TRUE(rowHolds(*assembler.snapshot(), 0, 40));
    ASSERT_EQ(assembler.popFinished().size(), 1U);
}

TEST(Sweep, StatusCodesScaleAndDeviceFlags) {
    SweepAssembler assembler;
    for (int n = 0; n < 6; ++n) {
        ScanTelegram telegram = telegramOfLine(n, {.beams = 21});
        telegram.channels16[0].scale = 2.0F;
        for (int beam = 0; beam < 17; ++beam) telegram.channels16[0].values[std::size_t(beam)] = static_cast<std::uint16_t>(beam);
        if (n == 3) telegram.status[0] = 2;
        pushTelegram(assembler, telegram, hostNsOfLine(n));
    }
    const auto scan = assembler.snapshot();
    EXPECT_EQ(scan->unitMm, 2.0);
    EXPECT_EQ(scan->state.at(0, 0), CellState::NoReturn);
    for (int beam = 1; beam < 16; ++beam) EXPECT_EQ(scan->state.at(2, beam), CellState::DeviceStatus);
    EXPECT_EQ(scan->rangeMm.at(2, 16), 32.0F);
    EXPECT_EQ(scan->statusCodes.size(), 15U);
    EXPECT_TRUE(assembler.progress().deviceEver.contaminationWarning);
    EXPECT_FALSE(assembler.progress().device.contaminationWarning);
    EXPECT_TRUE(warns(*scan, "dirty window (from line 3 on)"));
    EXPECT_TRUE(addsUp(*scan, assembler.progress()));
}

TEST(Sweep, LastEchoIsTheFarthest) {
    ScanTelegram telegram = telegramOfLine(0, {.beams = 3});
    ScanChannel second = telegram.channels16[0];
    second.content = "DIST2";
    telegram.channels16[0].values = {1000, 1000, 0};
    second.values = {5000, 0, 0};
    telegram.channels16.push_back(second);
    SweepSettings settings;
    settings.echo = Echo::Last;
    SweepAssembler assembler(settings);
    pushTelegram(assembler, telegram, hostNsOfLine(0));
    EXPECT_EQ(assembler.snapshot()->rangeMm.cells, (std::vector<float>{5000, 1000, 0}));
}

TEST(Sweep, ACopyGoesItsOwnWay) {
    SweepAssembler first = assembled({}, 10, {});
    const auto before = first.snapshot();
    const Scan kept = *before;
    SweepAssembler second = first;
    for (int n = 10; n < 20; ++n) pushTelegram(first, telegramOfLine(n), hostNsOfLine(n));
    for (int n = 30; n < 35; ++n) pushTelegram(second, telegramOfLine(n), hostNsOfLine(n));
    EXPECT_EQ(first.snapshot()->lines(), 20);
    EXPECT_EQ(second.snapshot()->lines(), 35);
    EXPECT_TRUE(rowIsLost(*second.snapshot(), 15));
    EXPECT_TRUE(rowHolds(*first.snapshot(), 15, 15));
    EXPECT_TRUE(sameScan(*before, kept)) << "a snapshot never changes";
}

TEST(Sweep, SettingsSurviveTheMetadata) {
    SweepSettings settings;
    settings.axis = Axis::Sweep;
    settings.lineDirection = -1;
    settings.firstLineDeg = -12.345678901234;
    settings.ticksPerDeg = -5555.5;
    settings.encoderZero = 4'000'000'000U;
    settings.degPerLine = -0.09;
    settings.continuous = false;
    settings.indexDeg = -140.25;
    settings.expectedLines = 777;
    settings.outputInterval = 2;
    settings.echo = Echo::Last;
    EXPECT_EQ(settingsOf(metadataOf(settings)).settings, settings);
    settings.degPerLine.reset();
    settings.degPerSecond = 3.25;
    EXPECT_EQ(settingsOf(metadataOf(settings)).settings, settings);
    settings = assumedSweep();
    EXPECT_EQ(settingsOf(metadataOf(settings)).settings, settings);
    settings.stepAssumed = false;
    EXPECT_EQ(settingsOf(metadataOf(settings)).settings, settings);
    EXPECT_EQ(metadataOf(settings).at("assumed"), "stepper.axis stepper.phi0_deg");
    EXPECT_EQ(settingsOf({}).settings, assumedSweep()); // a recording of another program
    const SettingsFound odd = settingsOf({{"stepper.deg_per_step", "much"}, {"stepper.axis", "[0,1,0]"}});
    EXPECT_EQ(odd.warnings.size(), 2U);
    EXPECT_EQ(odd.settings, SweepSettings{});
}

/// The parts of interlaced lines side by side.
void expectInterlaced(const std::filesystem::path& path, int beams) {
    SweepAssembler assembler;
    int telegrams = 0;
    for (const ColaFrame& frame : scanFramesOf(path)) {
        const auto telegram = decodeScanTelegram(frame);
        ASSERT_TRUE(telegram);
        pushTelegram(assembler, *telegram, kEpochNs + telegrams++ * 20'000'000LL);
    }
    assembler.finish();
    const auto scan = assembler.snapshot();
    ASSERT_TRUE(scan);
    EXPECT_EQ(scan->beams(), beams);
    EXPECT_EQ(scan->lines(), (telegrams + 1) / 2);
    EXPECT_TRUE(addsUp(*scan, assembler.progress()));
}

TEST(Sweep, InterlacedTelegrams) { expectInterlaced(ownTelegrams() / "interlaced.colab.bin", 115); }

TEST(Sweep, RealInterlacedTelegrams) {
    EDGESCAN_NEEDS_VECTORS();
    expectInterlaced(vectorsFolder() / "derived/interlaced.colab.bin", 1141);
}

TEST(Sweep, IntensitiesComeWithTheEchoThatIsTakenAndOnlyWhereTheTelegramHasThem) {
    const auto bright = [](int n, bool second) {
        ScanTelegram telegram = telegramOfLine(n);
        ScanChannel rssi = telegram.channels16[0];
        rssi.content = "RSSI1";
        for (std::size_t beam = 0; beam < rssi.values.size(); ++beam) rssi.values[beam] = static_cast<std::uint16_t>(10 * n + beam);
        if (second) {
            ScanChannel far = telegram.channels16[0];
            far.content = "DIST2";
            for (std::size_t beam = 0; beam < far.values.size(); ++beam)
                far.values[beam] = beam % 2 == 0 ? static_cast<std::uint16_t>(far.values[beam] + 500) : std::uint16_t{0};
            ScanChannel farRssi = rssi;
            farRssi.content = "RSSI2";
            for (std::uint16_t& value : farRssi.values) value = static_cast<std::uint16_t>(value + 1000);
            telegram.channels16.push_back(std::move(far));
            telegram.channels16.push_back(std::move(farRssi));
        }
        telegram.channels16.push_back(std::move(rssi));
        return telegram;
    };
    for (const Echo echo : {Echo::First, Echo::Last}) {
        SweepSettings settings;
        settings.echo = echo;
        SweepAssembler assembler(settings);
        for (int n = 0; n < 6; ++n) pushTelegram(assembler, telegramOfLine(n), hostNsOfLine(n)); // before RSSI was switched on
        EXPECT_EQ(assembler.snapshot()->intensity.size(), 0U);
        for (int n = 6; n < 30; ++n) {
            if (n != 12) pushTelegram(assembler, bright(n, true), hostNsOfLine(n));
        }
        const auto scan = assembler.snapshot();
        ASSERT_TRUE(scan);
        ASSERT_EQ(scan->intensity.size(), scan->cells());
        for (int line = 0; line < scan->lines(); ++line) {
            for (int beam = 0; beam < scan->beams(); ++beam) {
                const float value = scan->intensity.at(line, beam);
                if (line < 6 || line == 12) {
                    ASSERT_TRUE(std::isnan(value)) << line;
                    continue;
                }
                const float far = echo == Echo::Last && beam % 2 == 0 ? 1000.0F : 0.0F;
                ASSERT_EQ(value, static_cast<float>(10 * line + beam) + far) << line << ' ' << beam;
            }
        }
    }
}
