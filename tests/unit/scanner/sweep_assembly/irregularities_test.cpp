// Telegrams of faulty scanners: each is in its line or counted, each kind of fault is reported, and no line is invented.
#include "core/scanner/sweep_assembly/irregularities.h"
#include "tests/support/live_lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <random>
#include <set>

using namespace edgescan;
using namespace edgescan::scanner;
using namespace edgescan::test;

namespace {

struct Sent {
    ScanTelegram telegram;
    std::int64_t hostNs = 0;
};
using Stream = std::vector<Sent>;

Stream soundStream(int lines, const LineStyle& style = {}) {
    Stream stream;
    for (int n = 0; n < lines; ++n) stream.push_back({telegramOfLine(n, style), hostNsOfLine(n)});
    return stream;
}

/// The output of an assembler: the rows of every sweep by their content.
struct Result_ {
    SweepProgress progress; ///< after the end
    int sweeps = 0, lines = 0, lost = 0;
    std::map<std::vector<float>, int> rows; ///< whole rows, by their ranges
    std::string warnings;
    bool incomplete = false;
};

Result_ played(const Stream& stream, const SweepSettings& settings = {}) {
    SweepAssembler assembler(settings);
    Result_ result;
    const auto collect = [&] {
        for (const FinishedSweep& sweep : assembler.popFinished()) {
            ++result.sweeps;
            result.lines += sweep.progress.lines;
            result.lost += static_cast<int>(sweep.progress.lost.size());
            result.incomplete |= !sweep.progress.complete();
            EXPECT_TRUE(addsUp(*sweep.scan, sweep.progress));
            for (const std::string& warning : sweep.scan->warnings) {
                if (!warning.starts_with("The first line received")) result.warnings += warning + "\n";
            }
            for (int row = 0; row < sweep.scan->lines(); ++row) {
                const float* first = sweep.scan->rangeMm.line(row);
                if (sweep.scan->state.at(row, 0) != CellState::Lost) ++result.rows[{first, first + sweep.scan->beams()}];
            }
        }
    };
    for (const Sent& sent : stream) {
        pushTelegram(assembler, sent.telegram, sent.hostNs);
        EXPECT_TRUE(assembler.progress().account.addsUp());
        collect();
    }
    assembler.finish();
    collect();
    result.progress = assembler.progress();
    const TelegramAccount& account = result.progress.account;
    EXPECT_TRUE(account.addsUp());
    EXPECT_EQ(account.telegrams, static_cast<std::int64_t>(stream.size()));
    EXPECT_EQ(account.sweeps, result.sweeps);
    EXPECT_EQ(account.lines, result.lines);
    EXPECT_EQ(account.linesLost, result.lost);
    return result;
}

std::int64_t ever(const Result_& result, Irregularity kind) { return result.progress.irregularEver.count(kind); }

/// Whether every telegram's ranges are in some row.
bool keepsAll(const Result_& result, const Stream& stream) {
    return std::all_of(stream.begin(), stream.end(), [&](const Sent& sent) {
        const auto& values = sent.telegram.channels16.front().values;
        return result.rows.contains(std::vector<float>(values.begin(), values.end()));
    });
}

void set(ScanTelegram& telegram, std::int64_t telegramCounter, std::int64_t scanCounter) {
    telegram.telegramCounter = static_cast<std::uint16_t>(telegramCounter);
    telegram.scanCounter = static_cast<std::uint16_t>(scanCounter);
}
void setClock(ScanTelegram& telegram, std::int64_t us) {
    telegram.sinceStartUs = static_cast<std::uint32_t>(us);
    telegram.transmittedUs = telegram.sinceStartUs + 40'600;
}

} // namespace

TEST(Irregularities, ASoundStreamHasNone) {
    const Stream stream = soundStream(150);
    SweepSettings settings;
    settings.expectedLines = 150;
    const Result_ result = played(stream, settings);
    EXPECT_EQ(result.progress.text(), "150/150 lines");
    EXPECT_EQ(result.warnings, "");
    EXPECT_TRUE(keepsAll(result, stream));
    EXPECT_EQ(result.progress.irregularEver, Irregularities{});
}

TEST(Irregularities, CountersThatRunAheadOfEveryClockAreDoubted) {
    for (const int which : {1, 2, 3}) { // telegram counter, scan counter, both
        Stream stream = soundStream(151);
        for (int n = 0; n < 151; ++n) {
            ScanTelegram& t = stream[static_cast<std::size_t>(n)].telegram;
            set(t, (which & 1) != 0 ? 100 + 1000 * n : t.telegramCounter, (which & 2) != 0 ? 200 + 1000 * n : t.scanCounter);
        }
        SweepSettings settings;
        settings.expectedLines = 151;
        const Result_ result = played(stream, settings);
        EXPECT_TRUE(keepsAll(result, stream));
        EXPECT_EQ(result.progress.text(), "151/151 lines, COUNTERS IN DOUBT");
        EXPECT_GE(ever(result, Irregularity::CounterJump), 140) << which;
        EXPECT_GE(result.progress.irregularEver.implausibleLines(), 140 * 990);
        EXPECT_NE(result.warnings.find("jumped ahead"), std::string::npos) << result.warnings;
    }
}

TEST(Irregularities, LossesAndAJumpTogether) {
    Stream stream = soundStream(100);
    for (int n = 60; n < 100; ++n) {
        ScanTelegram& t = stream[static_cast<std::size_t>(n)].telegram;
        set(t, t.telegramCounter + 5000, t.scanCounter); // jumps once
    }
    stream.erase(stream.begin() + 30, stream.begin() + 37);
    stream.erase(stream.begin() + 80, stream.begin() + 82);
    const Result_ result = played(stream);
    EXPECT_TRUE(keepsAll(result, stream));
    EXPECT_EQ(result.lines, 100);
    EXPECT_EQ(result.lost, 9);
    EXPECT_EQ(ever(result, Irregularity::CounterJump), 1);
}

TEST(Irregularities, CountersThatRestartInTheMiddle) {
    for (const int which : {1, 2, 3}) {
        Stream stream = soundStream(120);
        for (int n = 50; n < 120; ++n) {
            ScanTelegram& t = stream[static_cast<std::size_t>(n)].telegram;
            set(t, (which & 1) != 0 ? n - 50 : t.telegramCounter, (which & 2) != 0 ? n - 50 : t.scanCounter);
        }
        Stream lossy = stream;
        lossy.erase(lossy.begin() + 48, lossy.begin() + 53); // five lines around the reset
        const Result_ whole = played(stream);
        EXPECT_TRUE(keepsAll(whole, stream)) << which;
        EXPECT_EQ(whole.lines, 120);
        EXPECT_EQ(whole.lost, 0);
        EXPECT_EQ(ever(whole, Irregularity::CounterReset), 1) << whole.warnings;
        EXPECT_NE(whole.warnings.find("set back"), std::string::npos) << whole.warnings;
        const Result_ result = played(lossy);
        EXPECT_EQ(result.lost, 5) << which << result.warnings;
        EXPECT_EQ(result.lines, 120);
    }
}

TEST(Irregularities, CountersThatRunBackwardOrStop) {
    for (const int step : {-1, 0}) {
        Stream stream = soundStream(80);
        for (int n = 0; n < 80; ++n) set(stream[static_cast<std::size_t>(n)].telegram, 30000 + step * n, 40000 + step * n);
        const Result_ result = played(stream);
        EXPECT_TRUE(keepsAll(result, stream)) << step;
        EXPECT_EQ(result.lines, 80);
        EXPECT_GE(ever(result, step == 0 ? Irregularity::CountersStopped : Irregularity::CounterReset), 78) << result.warnings;
        EXPECT_FALSE(result.warnings.empty());
    }
    // Stopped counters of a scanner with a known period: the clock counts instead.
    Stream stream = soundStream(80);
    for (int n = 40; n < 80; ++n) set(stream[static_cast<std::size_t>(n)].telegram, 139, 239);
    stream.erase(stream.begin() + 60, stream.begin() + 64);
    const Result_ result = played(stream);
    EXPECT_EQ(result.lines, 80);
    EXPECT_EQ(result.lost, 4);
    EXPECT_TRUE(result.progress.irregularEver.countersInDoubt());
}

TEST(Irregularities, AClockThatRunsBackwardJumpsOrStops) {
    struct Case {
        std::function<std::int64_t(int)> us;
        Irregularity kind;
        int times;
    };
    const std::vector<Case> cases{
        {[](int n) { return 4'000'000'000LL - 40'000LL * n; }, Irregularity::ClockJump, 99},
        {[](int n) { return 5'000'000LL - 40'000LL * n; }, Irregularity::ClockJump, 99}, // below zero at the end
        {[](int n) { return 77'000'000LL + 40'000LL * n - (n < 50 ? 0 : 3'600'000'000LL); }, Irregularity::ClockJump, 1},
        {[](int n) { return 77'000'000LL + 40'000LL * n + (n < 50 ? 0 : 3'600'000'000LL); }, Irregularity::ClockJump, 1},
        {[](int n) { return 77'000'000LL + 40'000LL * n + (n == 50 ? 60'000'000LL : 0); }, Irregularity::ClockJump, 2},
        {[](int) { return 123'456LL; }, Irregularity::ClockStopped, 99},
        {[](int n) { return 77'000'000LL + 40'000LL * std::min(n, 50); }, Irregularity::ClockStopped, 49},
    };
    for (const bool lossy : {false, true}) {
        for (std::size_t c = 0; c < cases.size(); ++c) {
            SCOPED_TRACE(std::to_string(c) + (lossy ? " lossy" : ""));
            Stream stream = soundStream(100);
            for (int n = 0; n < 100; ++n) setClock(stream[static_cast<std::size_t>(n)].telegram, cases[c].us(n));
            if (lossy) stream.erase(stream.begin() + 20, stream.begin() + 22);
            SweepSettings settings;
            settings.degPerLine.reset(); // line angles are computed from time
            settings.degPerSecond = 4.5;
            SweepAssembler assembler(settings);
            for (const Sent& sent : stream) pushTelegram(assembler, sent.telegram, sent.hostNs);
            const Result_ result = played(stream, settings);
            EXPECT_TRUE(keepsAll(result, stream));
            EXPECT_EQ(result.lines, 100);
            EXPECT_EQ(result.lost, lossy ? 2 : 0);
            EXPECT_NEAR(static_cast<double>(ever(result, cases[c].kind)), cases[c].times, 3) << result.warnings;
            EXPECT_NE(result.warnings.find("clock"), std::string::npos) << result.warnings;
            EXPECT_EQ(ever(result, Irregularity::Restart), 0);
            // Nevertheless time advances.
            const auto& lineDeg = std::get<PolarGeometry>(assembler.snapshot()->geometry).lineDeg;
            EXPECT_TRUE(std::is_sorted(lineDeg.begin(), lineDeg.end()));
            EXPECT_NEAR(lineDeg.back() - lineDeg.front(), 99 * 0.18, 0.5);
        }
    }
}

TEST(Irregularities, SeventyOneMinutesAndAPause) {
    Stream stream;
    for (int n = 0; n < 130'000; n += 500) stream.push_back({telegramOfLine(n, {.beams = 3}), hostNsOfLine(n)}); // 86 minutes
    SweepSettings settings;
    settings.longestGap = 1'000'000;
    settings.mostLines = 200'000;
    const Result_ wrapped = played(stream, settings);
    EXPECT_EQ(wrapped.lines, 129'501);
    EXPECT_EQ(ever(wrapped, Irregularity::ClockJump) + ever(wrapped, Irregularity::Restart) + ever(wrapped, Irregularity::Pause), 0);
    Stream paused = soundStream(60);
    for (int n = 30; n < 60; ++n) {
        Sent& sent = paused[static_cast<std::size_t>(n)];
        setClock(sent.telegram, sent.telegram.sinceStartUs + 90'000'000LL);
        sent.hostNs += 90'000'000'000LL;
    }
    const Result_ result = played(paused);
    EXPECT_TRUE(keepsAll(result, paused));
    EXPECT_EQ(result.lost, 0);
    EXPECT_EQ(ever(result, Irregularity::Pause), 1);
    EXPECT_NE(result.warnings.find("paused"), std::string::npos) << result.warnings;
}

TEST(Irregularities, LateTelegramsFillTheirLines) {
    std::mt19937 random(3);
    for (int round = 0; round < 40; ++round) {
        Stream stream = soundStream(100, {.beams = 15});
        std::int64_t moved = 0;
        for (std::size_t n = 20; n + 8 < stream.size(); n += 9) { // one of every nine arrives up to seven lines late
            const std::size_t by = 1 + random() % 7;
            Sent late = stream[n];
            late.hostNs = stream[n + by].hostNs + 1000;
            stream.erase(stream.begin() + static_cast<std::ptrdiff_t>(n));
            stream.insert(stream.begin() + static_cast<std::ptrdiff_t>(n + by), late);
            ++moved;
        }
        const Result_ result = played(stream);
        EXPECT_TRUE(keepsAll(result, stream));
        EXPECT_EQ(result.lines, 100);
        EXPECT_EQ(result.lost, 0);
        EXPECT_EQ(result.progress.account.lost, 0);
        EXPECT_EQ(ever(result, Irregularity::Late), moved);
        EXPECT_EQ(ever(result, Irregularity::Duplicate), 0);
    }
}

TEST(Irregularities, ABlockSentTwiceIsNoRestart) {
    for (const int length : {1, 5, 30}) {
        Stream stream = soundStream(100);
        const Stream block(stream.begin() + 70 - length, stream.begin() + 70);
        stream.insert(stream.begin() + 80, block.begin(), block.end());
        const Result_ result = played(stream);
        EXPECT_TRUE(keepsAll(result, stream));
        EXPECT_EQ(result.lines, 100);
        EXPECT_EQ(ever(result, Irregularity::Duplicate), length);
        EXPECT_EQ(ever(result, Irregularity::Restart), 0);
    }
}

TEST(Irregularities, AStreamThatRepeatsAllItsCountersIsKept) {
    Stream stream = soundStream(75);
    for (int n = 0; n < 75; ++n) { // the same counters and clock, other ranges
        Sent sent{telegramOfLine(n), hostNsOfLine(n + 75)};
        sent.telegram.channels16.front().values = telegramOfLine(n + 75).channels16.front().values;
        stream.push_back(sent);
    }
    const Result_ result = played(stream);
    EXPECT_TRUE(keepsAll(result, stream));
    EXPECT_EQ(result.lines, 150);
    EXPECT_EQ(result.lost, 0);
    EXPECT_EQ(ever(result, Irregularity::Restart), 1);
    EXPECT_NE(result.warnings.find("restarted"), std::string::npos) << result.warnings;
}

TEST(Irregularities, AScannerWithoutCountersAndClockIsKept) {
    Stream stream = soundStream(60);
    for (Sent& sent : stream) {
        set(sent.telegram, 0, 0);
        setClock(sent.telegram, 0);
    }
    const Result_ result = played(stream);
    EXPECT_TRUE(keepsAll(result, stream));
    EXPECT_EQ(result.lines, 60);
    EXPECT_TRUE(result.progress.irregularEver.countersInDoubt());
}

// 571 beams and 285 alternating: the beams missing in the shorter telegrams are lost, and those lines are not whole.
TEST(Irregularities, BeamCountsThatAlternateAreIncomplete) {
    Stream stream;
    for (int n = 0; n < 151; ++n) stream.push_back({telegramOfLine(n, {.beams = n % 2 == 0 ? 571 : 285, .step = 3333}), hostNsOfLine(n)});
    SweepSettings settings;
    settings.expectedLines = 151;
    const Result_ result = played(stream, settings);
    EXPECT_EQ(result.progress.text(), "INCOMPLETE 76/151 lines");
    EXPECT_EQ(result.progress.account.cellsLost, 75 * (571 - 285));
    EXPECT_EQ(result.progress.account.placed, 151);
    EXPECT_NE(result.warnings.find("fewer beams"), std::string::npos) << result.warnings;
    EXPECT_NE(result.warnings.find("(75 in all)"), std::string::npos) << result.warnings;
}

TEST(Irregularities, BeamsThatChangeInTheMiddleMakeAnotherSweep) {
    for (const LineStyle other : {LineStyle{.beams = 61, .startAngle = -45000}, LineStyle{.beams = 31, .step = 3333},
                                  LineStyle{.beams = 80}, LineStyle{.beams = 61, .startAngle = 100000}}) {
        Stream stream;
        for (int n = 0; n < 120; ++n) stream.push_back({telegramOfLine(n, n < 60 ? LineStyle{} : other), hostNsOfLine(n)});
        const Result_ result = played(stream);
        EXPECT_TRUE(keepsAll(result, stream));
        EXPECT_EQ(result.sweeps, 2);
        EXPECT_EQ(result.lines, 120);
        EXPECT_EQ(result.progress.account.unusable, 0);
    }
}

TEST(Irregularities, OddTelegramsAreCountedWhereverTheyCome) {
    const auto odd = [](int n) { return telegramOfLine(n, {.step = 5000}); };
    const auto empty = [](int n) {
        ScanTelegram telegram = telegramOfLine(n);
        telegram.channels16.clear();
        return telegram;
    };
    for (const int at : {40, 99}) { // in the middle, at the end
        for (const bool ranges : {true, false}) {
            Stream stream = soundStream(100);
            stream[static_cast<std::size_t>(at)].telegram = ranges ? odd(at) : empty(at);
            const Result_ result = played(stream);
            EXPECT_EQ(result.progress.account.unusable, 1);
            EXPECT_EQ(ever(result, ranges ? Irregularity::Misfit : Irregularity::NoRanges), 1);
            EXPECT_EQ(result.lines, 100);
            EXPECT_EQ(result.lost, 1);
            EXPECT_TRUE(result.incomplete);
        }
    }
    // All lines are different.
    Stream stream = soundStream(20);
    for (int n = 10; n < 16; ++n)
        stream[static_cast<std::size_t>(n)].telegram = telegramOfLine(n, {.beams = 20 + n, .step = 1700 + 100 * n});
    const Result_ result = played(stream);
    EXPECT_TRUE(keepsAll(result, stream));
    EXPECT_EQ(result.progress.account.unusable, 0);
    Stream none = soundStream(10);
    for (int n = 0; n < 10; ++n) none[static_cast<std::size_t>(n)].telegram = empty(n);
    EXPECT_EQ(played(none).progress.account.unusable, 10);
}

TEST(Irregularities, AnotherScannerAndAGapThatEndsTheSweepAreReported) {
    Stream stream = soundStream(60);
    for (int n = 30; n < 60; ++n) stream[static_cast<std::size_t>(n)].telegram.serialNumber = 4711;
    const Result_ other = played(stream);
    EXPECT_EQ(ever(other, Irregularity::OtherScanner), 1);
    EXPECT_NE(other.warnings.find("another scanner"), std::string::npos) << other.warnings;
    Stream gap = soundStream(30);
    for (int n = 3030; n < 3060; ++n) gap.push_back({telegramOfLine(n), hostNsOfLine(n)});
    const Result_ result = played(gap);
    EXPECT_EQ(result.sweeps, 2);
    EXPECT_EQ(ever(result, Irregularity::Gap), 3000);
    EXPECT_NE(result.warnings.find("3000 lines were lost between two sweeps"), std::string::npos) << result.warnings;
    EXPECT_EQ(result.progress.account.lost, 3000);
}

TEST(Irregularities, EchoesThatComeAndGoAreReported) {
    const auto second = [](ScanTelegram& telegram, int beams) {
        ScanChannel channel = telegram.channels16.front();
        channel.content = "DIST2";
        channel.values.resize(static_cast<std::size_t>(beams), 900);
        telegram.channels16.push_back(channel);
    };
    Stream both = soundStream(40);
    for (Sent& sent : both) second(sent.telegram, 61);
    EXPECT_EQ(played(both).warnings, "");
    Stream later = soundStream(40);
    for (std::size_t n = 30; n < 40; ++n) second(later[n].telegram, 61);
    EXPECT_EQ(ever(played(later), Irregularity::OtherEchoes), 10);
    Stream unlike = both;
    unlike[20].telegram.channels16.back().values.resize(30);
    unlike[25].telegram.channels16.erase(unlike[25].telegram.channels16.begin()); // only the second echo
    const Result_ result = played(unlike);
    EXPECT_EQ(ever(result, Irregularity::OtherEchoes), 2);
    EXPECT_NE(result.warnings.find("2 telegrams brought other echoes than the first one (first at line 20)"), std::string::npos)
        << result.warnings;
    EXPECT_EQ(result.lines, 40);
}

TEST(Irregularities, FrequenciesThatNoMirrorTurnsWith) {
    for (const std::uint32_t frequency : {0U, 1U, 4'294'967'295U}) {
        Stream stream = soundStream(60);
        for (Sent& sent : stream) sent.telegram.scanFrequency = frequency;
        stream.erase(stream.begin() + 20, stream.begin() + 25);
        const Result_ result = played(stream);
        EXPECT_EQ(result.lines, 60) << frequency;
        EXPECT_EQ(result.lost, 5);
    }
}

// Whatever arrives: nothing disappears, every cell is accounted for, and claims of counters do not allocate memory.
TEST(Irregularities, RandomFaultsOfEveryKindAlwaysAddUp) {
    for (unsigned seed = 1; seed <= 300; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937 random(seed);
        const auto oneIn = [&](unsigned n) { return random() % n == 0; };
        Stream stream;
        LineStyle style{.beams = 9};
        std::int64_t counter = random() % 70'000, scans = random() % 70'000, us = random(), hostNs = kEpochNs;
        for (int n = 0; n < 150; ++n) {
            const std::int64_t step = oneIn(15) ? static_cast<std::int64_t>(random() % 40) : 1;
            counter += oneIn(25) ? static_cast<std::int64_t>(random() % 65'536) : step;
            scans += oneIn(25) ? -static_cast<std::int64_t>(random() % 200) : step;
            us += oneIn(25) ? static_cast<std::int64_t>(random()) - (1LL << 31) : 40'000 * step;
            hostNs += oneIn(40) ? 0 : kPeriodNs * step;
            if (oneIn(40))
                style = {.beams = 3 + static_cast<int>(random() % 12),
                         .startAngle = -50000 + 10000 * static_cast<int>(random() % 3),
                         .step = oneIn(2) ? 1667 : 3333};
            Sent sent{telegramOfLine(n, style), hostNs};
            set(sent.telegram, counter, scans);
            setClock(sent.telegram, us);
            if (oneIn(30)) sent.telegram.channels16.clear();
            stream.push_back(sent);
            if (oneIn(20)) stream.push_back(stream[random() % stream.size()]);
            if (oneIn(20) && stream.size() > 9) std::swap(stream.back(), stream[stream.size() - 1 - random() % 8]);
        }
        SweepSettings settings;
        settings.expectedLines = oneIn(2) ? 40 : 0;
        const Result_ result = played(stream, settings);
        EXPECT_LE(result.progress.account.placed, static_cast<std::int64_t>(stream.size()));
        EXPECT_FALSE(result.warnings.empty());
    }
}
