// Scans of a growing sweep.
#include "core/scanner/sweep_assembly/sweep_assembler.h"
#include "tests/support/live_lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

using namespace edgescan;
using namespace edgescan::scanner;
using namespace edgescan::test;

// Whole rows do not change after the interlacing of the lines is known.
TEST(GrowingSweep, ScansOfOneSweepContinueEachOther) {
    constexpr unsigned kSeed = 8;
    SCOPED_TRACE(kSeed);
    std::mt19937 random(kSeed);
    int grown = 0;
    for (int round = 0; round < 40; ++round) {
        SweepSettings settings;
        settings.expectedLines = round % 3 == 0 ? 40 : 0;
        settings.ticksPerDeg = round % 4 == 1 ? std::optional<double>(5.0) : std::nullopt;
        SweepAssembler assembler(settings);
        std::map<int, std::shared_ptr<const Scan>> last; // by the sweep's number
        for (int n = 0; n < 120; ++n) {
            if (random() % 9 == 0) continue; // lost
            LineStyle style;
            if (round % 2 == 1 && n % 2 == 1) style.startAngle += 833; // interlaced: two lines make a row
            ScanTelegram telegram = telegramOfLine(n, style);
            if (round % 4 == 1) { // forward and back again
                const int turn = n % 60;
                telegram.encoders.push_back({static_cast<std::uint32_t>(1000 + (turn < 30 ? turn : 60 - turn)), 0});
            }
            pushTelegram(assembler, telegram, hostNsOfLine(n));
            if (random() % 15 == 0) pushTelegram(assembler, telegram, hostNsOfLine(n)); // twice
            const SweepState now{assembler.snapshot(), assembler.progress()};
            if (!now.scan || n < 20) continue;
            auto& before = last[now.progress.number];
            if (before && now.scan->lines() >= before->lines()) {
                ASSERT_EQ(before->beams(), now.scan->beams());
                ASSERT_TRUE(std::equal(before->rangeMm.cells.begin(), before->rangeMm.cells.end(), now.scan->rangeMm.cells.begin())) << n;
                ASSERT_TRUE(std::equal(before->state.cells.begin(), before->state.cells.end(), now.scan->state.cells.begin())) << n;
                ++grown;
            }
            before = std::make_shared<const Scan>(*now.scan);
            EXPECT_EQ(now.progress.growing, settings.expectedLines == 0 || now.progress.lines < settings.expectedLines);
        }
        assembler.finish();
        EXPECT_FALSE(assembler.progress().growing);
        for (const FinishedSweep& sweep : assembler.popFinished()) EXPECT_FALSE(sweep.progress.growing);
    }
    EXPECT_GT(grown, 2000);
}

// Telegrams whose counters are far apart: every measured line is in one of the sweeps, and no sweep consists of lost lines almost alone.
TEST(GrowingSweep, LostLinesDoNotOutnumberTheOthersByFar) {
    constexpr std::size_t kMostLost = 4'000'000; // cells
    struct Claim {
        int telegrams, beams, apart;
        bool severalSweeps;
    };
    for (const auto& [telegrams, beams, apart, severalSweeps] :
         {Claim{40, 1141, 997, true}, {40, 30, 1999, true}, {9, 30, 1999, false}, {3, 5000, 1500, true}, {12, 1141, 2, false}}) {
        SCOPED_TRACE(beams);
        SweepAssembler assembler;
        std::size_t sweeps = 0, measured = 0;
        const auto collect = [&] {
            for (const FinishedSweep& sweep : assembler.popFinished()) {
                ++sweeps;
                const std::size_t lost = sweep.progress.cells[static_cast<std::size_t>(CellState::Lost)];
                measured += sweep.scan->cells() - lost;
                EXPECT_LE(lost, kMostLost + sweep.scan->cells() - lost);
                EXPECT_TRUE(addsUp(*sweep.scan, sweep.progress));
                for (const int row : {0, sweep.scan->lines() - 1}) EXPECT_FALSE(rowIsLost(*sweep.scan, row));
            }
        };
        for (int n = 0; n < telegrams; ++n) {
            pushTelegram(assembler, telegramOfLine(n * apart, {.beams = beams, .step = 10}), hostNsOfLine(n * apart));
            collect();
        }
        assembler.finish();
        collect();
        EXPECT_EQ(measured, static_cast<std::size_t>(telegrams) * static_cast<std::size_t>(beams));
        EXPECT_EQ(assembler.progress().account.placed, telegrams);
        EXPECT_TRUE(assembler.progress().account.addsUp());
        EXPECT_EQ(sweeps > 1, severalSweeps);
    }
}
