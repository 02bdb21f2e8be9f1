// The noise of the flattest tiles: the true one on walls and bells, on all grids, and no leap with the size of a scan.
#include "core/scan/grid/inverse_range.h"

#include "app/lab/sim/simulate.h"
#include "tests/support/scans.h"

#include <gtest/gtest.h>

#include <random>

namespace edgescan {
namespace {

Scan bell(const char* scene, int lines, int beams, double noise, std::uint64_t seed = 3) {
    sim::SimulationSettings settings;
    settings.scene = scene;
    settings.seed = seed;
    settings.lines = lines;
    settings.beams = beams;
    settings.noise = noise;
    return sim::simulate(settings)->scan;
}

RangeNoise noiseOf(const Scan& scan) { return rangeNoise(inverseRange(scan)); }

double steady(const InverseRange& inverse) { return tileNoise(inverse, noiseByRange(inverse)).steady.at(5.0); }

TEST(RangeNoise, IsThatOfTheScannerOnRocks) {
    struct Row {
        const char* scene;
        double times;
    };
    for (const Row& row : {Row{"hangup", 1}, {"pile", 1}, {"hangup", 3}, {"pile", 3}})
        EXPECT_NEAR(noiseOf(bell(row.scene, 400, 457, row.times)).at(5.0), row.times * 6.75, 0.2 * row.times * 6.75)
            << row.scene << " x " << row.times;
}

// All differences together would give six times as much on the coarsest of them.
TEST(RangeNoise, IsThatOfTheScannerOnCoarseGrids) {
    for (const char* scene : {"hangup", "pile"}) {
        for (const auto& [lines, beams] : {std::pair{100, 120}, {150, 191}, {300, 381}}) {
            for (const std::uint64_t seed : {3U, 4U, 5U}) {
                const InverseRange inverse = inverseRange(bell(scene, lines, beams, 1, seed));
                EXPECT_NEAR(rangeNoise(inverse).at(5.0), 6.75, 0.6 * 6.75) << scene << " " << lines << " seed " << seed;
                EXPECT_NEAR(steady(inverse), 6.75, 0.1 * 6.75) << scene << " " << lines << " seed " << seed;
            }
        }
    }
}

TEST(RangeNoise, IsNotLessThanTwoThirdsOfTheMiddleTile) {
    // A third of the wall has no noise at all.
    const PolarGeometry polar = test::regularAngles(80, 240);
    std::mt19937 random(8);
    std::normal_distribution<double> noise(0.0, 40.0);
    const Scan wall =
        test::makeScan(80, 240, [&](int i, int j) { return test::wallRangeMm(polar, i, j, 4000.0) + (j < 80 ? 0.0 : noise(random)); });
    EXPECT_NEAR(noiseOf(wall).at(5.0), 40.0 / 1.5, 4.0);
}

TEST(RangeNoise, OfAPartIsThatOfTheWhole) {
    const InverseRange whole = inverseRange(bell("pile", 400, 457, 1));
    for (const int first : {0, 100, 200, 300}) {
        InverseRange part{Grid<float>(100, 457), Grid<Support>(100, 457)};
        std::copy_n(whole.u.cells.begin() + first * 457, part.u.size(), part.u.cells.begin());
        std::copy_n(whole.support.cells.begin() + first * 457, part.u.size(), part.support.cells.begin());
        EXPECT_EQ(steady(part), steady(whole)) << first;
    }
}

// A scan that grows line by line: between few and enough tiles the noise moves from one rule to the other in small steps.
TEST(RangeNoise, HasNoLeapWithTheNumberOfTiles) {
    const PolarGeometry polar = test::regularAngles(320, 40);
    std::mt19937 random(6);
    std::normal_distribution<double> noise(0.0, 6.75);
    const Scan whole = test::makeScan(320, 40, [&](int i, int j) {
        return test::wallRangeMm(polar, i, j, 4000.0) + 30.0 * ((i / 8 + j / 8) % 2) * (j % 8) + noise(random);
    });
    const InverseRange all = inverseRange(whole);
    double before = 0;
    bool differs = false;
    for (int lines = 24; lines <= 320; lines += 8) {
        InverseRange part{Grid<float>(lines, 40), Grid<Support>(lines, 40)};
        std::copy_n(all.u.cells.begin(), part.u.size(), part.u.cells.begin());
        std::copy_n(all.support.cells.begin(), part.u.size(), part.support.cells.begin());
        const double ofTiles = rangeNoise(part).at(5.0), ofRange = noiseByRange(part).at(5.0);
        if (lines <= 40) EXPECT_EQ(ofTiles, ofRange) << "25 tiles and fewer";
        differs = differs || std::abs(ofTiles - ofRange) > 0.5;
        if (lines > 48) EXPECT_NEAR(ofTiles, before, 0.2 * before) << lines;
        before = ofTiles;
    }
    EXPECT_TRUE(differs);
}

TEST(RangeNoise, OfNothingIsNil) {
    EXPECT_EQ(noiseOf(test::makeScan(3, 3, [](int, int) { return 0.0; })).at(5.0), 0.0);
    EXPECT_EQ(noiseOf(test::makeScan(64, 64, [](int, int) { return 0.0; })).at(5.0), 0.0);
}

} // namespace
} // namespace edgescan
