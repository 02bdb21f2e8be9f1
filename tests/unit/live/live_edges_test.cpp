// Edges of a growing scan, line by line, against the whole method on the lines so far.
#include "core/live/live_edges.h"
#include "core/method/pipeline.h"
#include "core/settings/presets.h"
#include "tests/support/scans.h"

#include <gtest/gtest.h>

using namespace edgescan;
using namespace edgescan::test;

namespace {

/// Every line of the scan, `stride` at a time; the result is compared after each.
void expectExact(const Scan& scan, const Settings& settings, int stride) {
    auto live = LiveEdges::make(settings);
    ASSERT_TRUE(live) << live.error().sentence();
    Pipeline pipeline;
    for (int lines = stride; lines <= scan.lines(); lines += stride) {
        const auto part = firstLines(scan, lines);
        live->update(*part);
        const auto expected = pipeline.run(part, settings);
        ASSERT_EQ(live->gray(), expected->gray->levels) << lines;
        ASSERT_EQ(live->smoothed(), *expected->smoothed) << lines;
        ASSERT_EQ(live->mask(), *expected->mask) << lines;
        if (lines % 16 != 0) continue;
        const auto detection = live->detection(part);
        ASSERT_EQ(*detection->edges, *expected->edges);
        ASSERT_EQ(detection->gray->saturated, expected->gray->saturated);
    }
}

Settings randomSettings(std::mt19937& random) {
    Settings settings = cannySettings();
    const auto pick = [&](auto... values) {
        const double list[] = {static_cast<double>(values)...};
        return list[random() % sizeof...(values)];
    };
    settings.scaling = random() % 2 == 0 ? Scaling::Log : Scaling::Window;
    settings.nearMm = pick(500, 1800, 2500.5);
    settings.farMm = pick(4000, 9000, 15000);
    settings.kernel = static_cast<int>(pick(1, 3, 5, 7, 9, 11));
    settings.sigma = random() % 2 == 0 ? kAutomatic : pick(0.6, 1.4, 3.0);
    settings.aperture = static_cast<int>(pick(3, 5, 7));
    settings.lower = settings.aperture == 3 ? pick(2, 6, 20) : settings.aperture == 5 ? pick(20, 150) : pick(200, 2000);
    settings.ratio = pick(1, 2, 3, 8);
    settings.norm = random() % 2 == 0 ? Norm::L1 : Norm::L2;
    settings.maskMissing = random() % 3 != 0;
    settings.maskIsolated = random() % 2 == 0;
    return settings;
}

} // namespace

TEST(LiveEdges, EveryLineEqualsTheWholeMethodWithEverySetting) {
    std::mt19937 random(1);
    for (int round = 0; round < 90; ++round) {
        const int lines = 1 + static_cast<int>(random() % 48);
        const int beams = round % 15 == 0 ? 1 + static_cast<int>(random() % 3) : 20 + static_cast<int>(random() % 40);
        const Scan scan = boxesScan(lines, beams, static_cast<unsigned>(random()), round % 3 == 0 ? 0.0 : 0.15);
        SCOPED_TRACE(round);
        expectExact(scan, randomSettings(random), 1 + static_cast<int>(random() % (round % 4 == 0 ? 5 : 1)));
        if (HasFatalFailure()) return;
    }
}

TEST(LiveEdges, EveryKernelApertureAndMaskingOnce) {
    for (const int kernel : {1, 3, 5, 7, 9, 11}) {
        for (const int aperture : {3, 5, 7}) {
            for (const int masking : {0, 1, 2}) {
                Settings settings = cannySettings();
                settings.nearMm = 1500;
                settings.farMm = 9500;
                settings.kernel = kernel;
                settings.aperture = aperture;
                settings.lower = aperture == 3 ? 6 : aperture == 5 ? 60 : 600;
                settings.maskMissing = masking > 0;
                settings.maskIsolated = masking > 1;
                SCOPED_TRACE(testing::Message() << kernel << ' ' << aperture << ' ' << masking);
                expectExact(boxesScan(30, 40, static_cast<unsigned>(kernel * 10 + aperture), 0.1), settings, 1);
                if (HasFatalFailure()) return;
            }
        }
    }
}

// A long chain of weak cells that only the last line decides.
TEST(LiveEdges, ALateStrongCellReachesBackThroughALongWeakChain) {
    const Scan scan = makeScan(60, 30, [](int i, int j) { return j < 15 ? 3000.0 : (i < 55 ? 3300.0 : 9000.0); });
    Settings settings = cannySettings();
    settings.nearMm = 1000;
    settings.farMm = 9500;
    settings.maskMissing = false;
    expectExact(scan, settings, 1);
}

TEST(LiveEdges, RangesThatAreNoWholeMillimetres) {
    Scan scan = boxesScan(20, 30, 3, 0.1);
    for (std::size_t k = 0; k < scan.cells(); ++k) scan.rangeMm[k] += 0.37F * static_cast<float>(k % 5);
    Settings settings = cannySettings();
    settings.nearMm = 1500;
    settings.farMm = 9000;
    expectExact(scan, settings, 1);
}

TEST(LiveEdges, AnotherScanIsBegunAnew) {
    Settings settings = cannySettings();
    settings.nearMm = 1500;
    settings.farMm = 9500;
    auto live = LiveEdges::make(settings);
    ASSERT_TRUE(live);
    for (const unsigned seed : {1U, 2U, 3U}) {
        const auto scan = std::make_shared<const Scan>(boxesScan(30 + static_cast<int>(seed), 40, seed));
        live->update(*scan);
        EXPECT_EQ(live->mask(), *detectEdges(scan, settings)->mask) << seed;
    }
    const auto fewer = firstLines(boxesScan(30, 40, 3), 7);
    live->update(*fewer);
    EXPECT_EQ(live->mask(), *detectEdges(fewer, settings)->mask);
}

TEST(LiveEdges, AutomaticWindowsAreFixedFirst) {
    const auto scan = std::make_shared<const Scan>(boxesScan(40, 50, 9, 0.05));
    for (const Scaling scaling : {Scaling::Log, Scaling::Window, Scaling::Thesis}) {
        Settings settings = cannySettings();
        settings.scaling = scaling;
        EXPECT_FALSE(LiveEdges::make(settings));
        const Settings fixed = withFixedWindow(settings, *scan);
        auto live = LiveEdges::make(fixed);
        ASSERT_TRUE(live);
        live->update(*scan);
        EXPECT_EQ(live->mask(), *detectEdges(scan, settings)->mask) << static_cast<int>(scaling);
    }
}
