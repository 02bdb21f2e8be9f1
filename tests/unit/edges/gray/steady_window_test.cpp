// The range window that is fixed while a sweep grows.
#include "core/edges/gray/steady_window.h"
#include "core/edges/pipeline/pipeline.h"
#include "core/edges/settings/presets.h"
#include "tests/support/scans.h"

#include <gtest/gtest.h>

#include <set>

using namespace edgescan;
using namespace edgescan::edges;
using namespace edgescan::test;

namespace {

/// Rows of a near wall first, then of a farther one: an automatic window would move.
Scan recedingScan(int lines, int beams) {
    return makeScan(lines, beams,
                    [&](int i, int j) { return 2000 + (i > lines / 2 ? 40 * i : 0) + (j / 10 % 2) * 300 + (i * 7 + j * 3) % 11; });
}

} // namespace

TEST(SteadyWindow, IsFixedAndRarelyMoves) {
    const Scan whole = recedingScan(200, 60);
    for (const Scaling scaling : {Scaling::Log, Scaling::Window, Scaling::Thesis}) {
        Settings settings;
        settings.scaling = scaling;
        SteadyWindow window;
        std::set<std::pair<double, double>> windows;
        for (int lines = 1; lines <= 200; lines += 3) {
            const Settings fixed = window.fix(*firstLines(whole, lines), settings);
            ASSERT_FALSE(std::isnan(fixed.nearMm) || std::isnan(fixed.farMm));
            ASSERT_NE(fixed.scaling, Scaling::Thesis);
            EXPECT_EQ(fixed.lower, settings.lower);
            windows.insert({fixed.nearMm, fixed.farMm});
        }
        EXPECT_LE(windows.size(), 8U) << "once per doubling at most";
    }
}

TEST(SteadyWindow, OfTheWholeScanGivesTheEdgesOfTheWholeScan) {
    const auto whole = firstLines(recedingScan(120, 60), 120);
    for (const Scaling scaling : {Scaling::Log, Scaling::Window, Scaling::Thesis}) {
        Settings settings = cannySettings();
        settings.scaling = scaling;
        EXPECT_EQ(*detectEdges(whole, SteadyWindow().fix(*whole, settings))->mask, *detectEdges(whole, settings)->mask);
    }
}

TEST(SteadyWindow, ASliderKeepsItAndATypedLimitCounts) {
    const Scan whole = recedingScan(100, 50);
    SteadyWindow window;
    Settings settings = cannySettings();
    const Settings before = window.fix(*firstLines(whole, 40), settings);
    settings.lower += 3;
    settings.kernel = 5;
    const Settings after = window.fix(*firstLines(whole, 45), settings);
    EXPECT_EQ(after.nearMm, before.nearMm);
    EXPECT_EQ(after.farMm, before.farMm);
    EXPECT_EQ(after.kernel, 5);
    settings.nearMm = 1000;
    settings.farMm = 5000;
    const Settings typed = window.fix(*firstLines(whole, 46), settings);
    EXPECT_EQ(typed.nearMm, 1000);
    EXPECT_EQ(typed.farMm, 5000);
}

TEST(SteadyWindow, TheNextSweepBeginsWithItAndLooksAgainSoon) {
    const Scan nearer = makeScan(400, 50, [](int, int j) { return 2000 + j; });
    const Scan farther = makeScan(400, 50, [](int, int j) { return 20000 + j; });
    SteadyWindow window;
    const Settings settings;
    const Settings first = window.fix(nearer, settings);
    EXPECT_EQ(window.fix(*firstLines(farther, 30), settings).farMm, first.farMm) << "the same sweep: it has not doubled";
    window.nextSweep();
    EXPECT_EQ(window.fix(*firstLines(farther, 15), settings).farMm, first.farMm);
    EXPECT_GT(window.fix(*firstLines(farther, 16), settings).farMm, 2 * first.farMm);
}
