// Losses, wraps, duplicates and restarts, detected from the scanner's counters and clock.
#include "core/base/utc_time.h"
#include "core/scanner/sick_lms/sweep_feed.h"
#include "core/scanner/sweep_assembly/counters.h"
#include "tests/support/cola_vectors.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

using namespace edgescan;
using namespace edgescan::scanner;
using namespace edgescan::test;

namespace {

constexpr std::int64_t kPeriodUs = 40000;

/// Scan number n of a scanner that sends every `interval`-th scan and was switched on long ago.
ScanTelegram scanNumber(std::int64_t n, std::int64_t interval = 1) {
    ScanTelegram telegram;
    telegram.scanFrequency = 2500;
    telegram.telegramCounter = static_cast<std::uint16_t>(n / interval + 60000);
    telegram.scanCounter = static_cast<std::uint16_t>(n + 64000);
    telegram.sinceStartUs = static_cast<std::uint32_t>(n * kPeriodUs + 0xFFF00000);
    telegram.transmittedUs = telegram.sinceStartUs + 40600;
    return telegram;
}
std::int64_t hostOf(std::int64_t n) { return n * kPeriodUs * 1000; }

std::vector<LineStamp> stampsOf(const std::filesystem::path& path) {
    LineCounter counter;
    std::vector<LineStamp> stamps;
    for (const ColaFrame& frame : scanFramesOf(path)) stamps.push_back(counter.stamp(countOf(*decodeScanTelegram(frame)), 0));
    return stamps;
}

} // namespace

TEST(LineCounter, RealCaptureHasNoLoss) {
    EDGESCAN_NEEDS_VECTORS();
    const auto stamps = stampsOf(vectorsFolder() / "lms511_a_d2h.bin");
    for (std::size_t i = 1; i < stamps.size(); ++i) {
        EXPECT_EQ(stamps[i].step, LineStep::Next);
        EXPECT_EQ(stamps[i].lost, 0);
        EXPECT_NEAR(static_cast<double>(stamps[i].deviceUs - stamps[i - 1].deviceUs), 40001.0, 400.0);
        EXPECT_NEAR(static_cast<double>(stamps[i].transmittedUs - stamps[i].deviceUs), 40800.0, 1000.0);
    }
}

TEST(LineCounter, CountersAndClockPassTheirEnds) {
    for (const char* name : {"plain.colaa.bin", "plain.colab.bin"}) {
        const auto stamps = stampsOf(ownTelegrams() / name);
        ASSERT_EQ(stamps.size(), 4U);
        for (std::size_t i = 1; i < stamps.size(); ++i) {
            EXPECT_EQ(stamps[i].step, LineStep::Next);
            EXPECT_EQ(stamps[i].lost, 0);
            EXPECT_EQ(stamps[i].telegram, 65534 + static_cast<std::int64_t>(i));
            EXPECT_EQ(stamps[i].deviceUs, 4294950000 + static_cast<std::int64_t>(i) * 40000);
        }
    }
}

TEST(LineCounter, DerivedVariants) {
    EDGESCAN_NEEDS_VECTORS();
    const auto derived = vectorsFolder() / "derived";
    std::vector<std::int64_t> lost;
    std::vector<LineStep> steps;
    for (const LineStamp& stamp : stampsOf(derived / "loss_and_duplicate.colab.bin")) {
        lost.push_back(stamp.lost);
        steps.push_back(stamp.step);
    }
    using enum LineStep;
    EXPECT_EQ(lost, (std::vector<std::int64_t>{0, 0, 1, 0, 0, 3}));
    EXPECT_EQ(steps, (std::vector<LineStep>{First, Next, Next, Next, Duplicate, Next}));
    const auto wrapped = stampsOf(derived / "wraparound.colaa.bin");
    ASSERT_EQ(wrapped.size(), 4U);
    for (std::size_t i = 1; i < wrapped.size(); ++i) {
        EXPECT_EQ(wrapped[i].lost, 0);
        EXPECT_EQ(wrapped[i].telegram, 65534 + static_cast<std::int64_t>(i));
        EXPECT_EQ(wrapped[i].deviceUs, 4294907295 + static_cast<std::int64_t>(i) * 40000);
    }
    for (const LineStamp& stamp : stampsOf(derived / "interlaced.colab.bin")) EXPECT_EQ(stamp.lost, 0);
    for (const LineStamp& stamp : stampsOf(derived / "encoder1.colab.bin")) EXPECT_EQ(stamp.lost, 0);
}

TEST(LineCounter, HoursOfLinesWithLossesDuplicatesAndBothWraps) {
    for (const std::int64_t interval : {1, 2, 5}) {
        std::mt19937 random(7);
        LineCounter counter;
        (void)counter.stamp(countOf(scanNumber(0, interval)), hostOf(0));
        (void)counter.stamp(countOf(scanNumber(interval, interval)), hostOf(interval));
        std::int64_t n = interval;
        const std::int64_t last = 400000; // 4.4 hours: six wraps of the counters, three of the clock
        while (n < last) {
            const std::int64_t lost = random() % 50 == 0 ? static_cast<std::int64_t>(random() % 200) : 0;
            n += (lost + 1) * interval;
            const LineStamp stamp = counter.stamp(countOf(scanNumber(n, interval)), hostOf(n));
            ASSERT_EQ(stamp.step, LineStep::Next) << n;
            ASSERT_EQ(stamp.lost, lost) << n;
            ASSERT_EQ(stamp.telegram, n / interval + 60000);
            ASSERT_EQ(stamp.scan, n + 64000);
            ASSERT_EQ(stamp.deviceUs, n * kPeriodUs + 0xFFF00000);
            if (random() % 20 == 0) {
                const LineStamp again = counter.stamp(countOf(scanNumber(n, interval)), hostOf(n) + 1000);
                ASSERT_EQ(again.step, LineStep::Duplicate);
                ASSERT_EQ(again.telegram, stamp.telegram);
            }
        }
    }
}

TEST(LineCounter, ScansThatTheScannerSkippedCountAsLost) {
    LineCounter counter;
    for (std::int64_t n = 0; n < 5; ++n) (void)counter.stamp(countOf(scanNumber(n)), hostOf(n));
    ScanTelegram telegram = scanNumber(7); // two scans later, but the telegram counter increased by one only
    telegram.telegramCounter = static_cast<std::uint16_t>(scanNumber(4).telegramCounter + 1);
    const LineStamp stamp = counter.stamp(countOf(telegram), hostOf(7));
    EXPECT_EQ(stamp.lostTelegrams, 0);
    EXPECT_EQ(stamp.lostScans, 2);
    EXPECT_EQ(stamp.lost, 2);
}

TEST(LineCounter, OneCounterMayRestart) {
    LineCounter counter;
    for (std::int64_t n = 0; n < 5; ++n) (void)counter.stamp(countOf(scanNumber(n)), hostOf(n));
    ScanTelegram telegram = scanNumber(5);
    telegram.scanCounter = 4;
    EXPECT_EQ(counter.stamp(countOf(telegram), hostOf(5)).step, LineStep::Next);
    telegram = scanNumber(8);
    telegram.scanCounter = 7;
    const LineStamp stamp = counter.stamp(countOf(telegram), hostOf(8));
    EXPECT_EQ(stamp.step, LineStep::Next);
    EXPECT_EQ(stamp.lost, 2);
}

TEST(LineCounter, RestartsAreNoGaps) {
    for (const bool reconnected : {true, false}) {
        LineCounter counter;
        for (std::int64_t n = 0; n < 100; ++n) (void)counter.stamp(countOf(scanNumber(n)), hostOf(n));
        if (reconnected) counter.reconnected();
        ScanTelegram fresh = scanNumber(0); // power was lost: everything starts again
        fresh.telegramCounter = 1;
        fresh.scanCounter = 1;
        fresh.sinceStartUs = 90000;
        const LineStamp stamp = counter.stamp(countOf(fresh), hostOf(1000));
        EXPECT_EQ(stamp.step, LineStep::Restart);
        EXPECT_EQ(stamp.epoch, 1);
        EXPECT_EQ(stamp.lost, 0);
        EXPECT_EQ(stamp.telegram, 1);
        fresh.telegramCounter = 4;
        fresh.scanCounter = 4;
        fresh.sinceStartUs += 120000;
        EXPECT_EQ(counter.stamp(countOf(fresh), hostOf(1003)).lost, 2);
    }
}

TEST(LineCounter, LinesLostWhileNobodyListenedAreCounted) {
    LineCounter counter;
    (void)counter.stamp(countOf(scanNumber(0)), hostOf(0));
    for (const std::int64_t gap : {2, 130, 40000, 70000, 300000}) { // up to 3.3 hours: all counters and clocks wrap more than once
        LineCounter own = counter;
        own.reconnected();
        const LineStamp stamp = own.stamp(countOf(scanNumber(gap)), hostOf(gap));
        EXPECT_EQ(stamp.step, LineStep::Next) << gap;
        EXPECT_EQ(stamp.lost, gap - 1);
    }
}

TEST(LineCounter, APlayerThatBeginsAgainAfterReconnectingIsNoDuplicate) {
    LineCounter counter;
    for (std::int64_t n = 0; n < 5; ++n) (void)counter.stamp(countOf(scanNumber(n)), hostOf(n));
    EXPECT_EQ(counter.stamp(countOf(scanNumber(3)), hostOf(5)).step, LineStep::Duplicate); // late, on the same connection
    counter.reconnected();
    EXPECT_EQ(counter.stamp(countOf(scanNumber(2)), hostOf(30)).step, LineStep::Restart);
    EXPECT_EQ(counter.stamp(countOf(scanNumber(3)), hostOf(31)).step, LineStep::Next);
}

TEST(LineCounter, APauseOfTheMeasurementIsNoLoss) {
    LineCounter counter;
    (void)counter.stamp(countOf(scanNumber(0)), hostOf(0));
    (void)counter.stamp(countOf(scanNumber(1)), hostOf(1));
    ScanTelegram telegram = scanNumber(2);
    telegram.sinceStartUs += 60'000'000;
    const LineStamp stamp = counter.stamp(countOf(telegram), hostOf(2) + 60'000'000'000);
    EXPECT_EQ(stamp.step, LineStep::Next);
    EXPECT_EQ(stamp.lost, 0);
}

TEST(LineCounter, DevicesThatDoNotCountOrHaveNoClock) {
    LineCounter counter;
    ScanTelegram telegram = scanNumber(0);
    (void)counter.stamp(countOf(telegram), 0);
    telegram.sinceStartUs += 40000;
    EXPECT_EQ(counter.stamp(countOf(telegram), 40'000'000).step, LineStep::Next);
    LineCounter clockless;
    (void)clockless.stamp(countOf(telegram), 0);
    telegram.telegramCounter = static_cast<std::uint16_t>(telegram.telegramCounter + 3);
    telegram.scanCounter = static_cast<std::uint16_t>(telegram.scanCounter + 3);
    const LineStamp stamp = clockless.stamp(countOf(telegram), 120'000'000);
    EXPECT_EQ(stamp.step, LineStep::Next);
    EXPECT_EQ(stamp.lost, 2);
}

// Two clocks of 64 bits: nothing is cut before 2262, and no difference overflows.
TEST(DeviceClock, CarriesTimesOfEveryCentury) {
    constexpr std::int64_t kYearNs = 31'556'952'000'000'000;
    for (int year = 0; year < 292; ++year) {
        DeviceClock clock;
        const std::int64_t host = year * kYearNs + 123'456'789;
        clock.line(5'000'000, host);
        EXPECT_EQ(clock.hostNs(6'000'000), host + 1'000'000'000) << 1970 + year;
    }
    constexpr std::int64_t kLeast = std::numeric_limits<std::int64_t>::min(), kMost = std::numeric_limits<std::int64_t>::max();
    for (const std::int64_t host : {kLeast, std::int64_t{0}, kMost}) {
        for (const std::int64_t device : {kLeast, std::int64_t{0}, kMost}) {
            for (const std::int64_t asked : {kLeast, std::int64_t{0}, kMost}) {
                DeviceClock clock;
                clock.line(device, host);
                EXPECT_GE(clock.hostNs(asked), kEarliestNs);
                EXPECT_LE(clock.hostNs(asked), kLatestNs);
            }
        }
    }
}
