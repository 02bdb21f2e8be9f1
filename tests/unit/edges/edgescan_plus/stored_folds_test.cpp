// Folds from stored numbers: at every crease angle the same bits as measured folds.
#include "core/edges/edgescan_plus/stored_folds.h"

#include "app/lab/sim/simulate.h"
#include "core/edges/edgescan_plus/edgescan_plus.h"
#include "core/edges/pipeline/pipeline.h"
#include "core/edges/settings/parameters.h"
#include "tests/support/scans.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <random>

namespace edgescan::edges {
namespace {

bool haveSameBits(const Grid<float>& a, const Grid<float>& b) {
    return a.lines == b.lines && a.beams == b.beams && std::memcmp(a.cells.data(), b.cells.data(), a.size() * sizeof(float)) == 0;
}

void expectSameResponses(const DepthResponses& found, const DepthResponses& fresh) {
    EXPECT_TRUE(haveSameBits(*found.jump, *fresh.jump));
    EXPECT_TRUE(haveSameBits(found.crease, fresh.crease));
    EXPECT_TRUE(haveSameBits(found.unweighed, fresh.unweighed));
    EXPECT_TRUE(haveSameBits(found.roughness.around, fresh.roughness.around));
    EXPECT_EQ(found.roughness.rough, fresh.roughness.rough);
    EXPECT_EQ(found.roughness.share, fresh.roughness.share);
    EXPECT_EQ(found.roughness.aroundFolds, fresh.roughness.aroundFolds);
    EXPECT_EQ(found.jumpMm, fresh.jumpMm);
    EXPECT_EQ(found.noise.at(7), fresh.noise.at(7));
    EXPECT_EQ(found.foldNoise.at(7), fresh.foldNoise.at(7));
    EXPECT_EQ(found.neighboursAlike, fresh.neighboursAlike);
    EXPECT_EQ(found.border, fresh.border);
    EXPECT_EQ(found.silhouettes, fresh.silhouettes);
    EXPECT_EQ(found.rim, fresh.rim);
}

// Pyramids on a wall: a scan that folds everywhere.
Scan roughWall(std::mt19937& random) {
    const int lines = 100 + static_cast<int>(random() % 80), beams = 100 + static_cast<int>(random() % 120);
    const PolarGeometry polar = test::regularAngles(lines, beams);
    const double period = 8.0 + static_cast<double>(random() % 8);
    std::normal_distribution<double> noise(0.0, 4.0);
    return test::makeScan(lines, beams, [&](int i, int j) {
        const auto wave = [&](double n) { return std::abs(std::fmod(n, period) - period / 2) * 12 / period; };
        return test::wallRangeMm(polar, i, j, 4000.0 - 120.0 * (wave(i) + wave(j)) / 6) + std::round(noise(random));
    });
}

// Surfaces of all kinds, and none at all, in sizes around those of the loops' blocks.
Scan scanOfAnyKind(std::mt19937& random) {
    if (random() % 5 == 0) return roughWall(random);
    const auto upTo = [&](unsigned most) { return static_cast<int>(random() % most); };
    if (random() % 3 != 0) {
        sim::SimulationSettings settings;
        settings.seed = random();
        settings.lines = 2 + upTo(120);
        settings.beams = 3 + upTo(300);
        settings.noise = std::array{0.0, 0.3, 1.0, 3.0}[random() % 4];
        settings.dropouts = random() % 2 == 0 ? 0.0 : 0.1;
        settings.slips = random() % 3 == 0 ? 0.05 : 0.0;
        return std::move(sim::simulate(settings)->scan);
    }
    const int lines = 1 + upTo(70), beams = 1 + upTo(270);
    const std::uint32_t most = 1U << (random() % 12U), holes = random() % 4;
    return test::makeScan(lines, beams, [&](int i, int j) {
        return random() % 8 < holes ? 0.0 : 2000.0 + static_cast<double>(random() % most) + 200.0 * ((i / 7 + j / 11) % 4);
    });
}

TEST(StoredFolds, CoverTheSliderOfTheCreaseAngle) {
    const Parameter& crease = *findParameter("crease");
    EXPECT_EQ(StoredFolds::kLeastDeg, crease.minimum);
    EXPECT_EQ(StoredFolds::kMostDeg, crease.maximum);
    EXPECT_EQ(crease.step, 1);
    EXPECT_TRUE(StoredFolds::covers(15, 65536) && StoredFolds::covers(90, 65536));
    EXPECT_FALSE(StoredFolds::covers(14, 9) || StoredFolds::covers(91, 9) || StoredFolds::covers(30.5, 9) ||
                 StoredFolds::covers(30, 65537));
}

TEST(StoredFolds, GiveTheBitsOfMeasuredFoldsAtEveryAngle) {
    std::mt19937 random(20261123);
    int rough = 0, folding = 0;
    for (int round = 0; round < 24; ++round) {
        const Scan scan = scanOfAnyKind(random);
        Settings settings;
        if (random() % 4 == 0) settings.noiseMm = static_cast<double>(1 + random() % 30);
        settings.roughScans = random() % 4 != 0;
        settings.rules = 4 + static_cast<int>(random() % 2);
        settings.noiseKind = random() % 5 == 0 ? NoiseKind::Camera : NoiseKind::Measured;
        const DepthSurface surface = depthSurface(scan, settings, 1);
        settings.creaseDeg = static_cast<double>(15 + random() % 76);
        StoredFolds folds;
        const int threads = 1 + static_cast<int>(random() % 4);
        DepthResponses responses = depthResponses(surface, settings, nullptr, threads, &folds);
        expectSameResponses(responses, depthResponses(surface, settings, nullptr, 1));
        for (const double deg : {15.0, 90.0, static_cast<double>(15 + random() % 76), static_cast<double>(15 + random() % 76), 30.0}) {
            SCOPED_TRACE(std::to_string(round) + ": " + std::to_string(deg) + " degrees, " + std::to_string(scan.lines()) + " x " +
                         std::to_string(scan.beams()));
            settings.creaseDeg = deg;
            responses = withCreaseAngle(responses, folds, surface, settings, 1 + static_cast<int>(random() % 4));
            const DepthResponses fresh = depthResponses(surface, settings, nullptr, 1);
            expectSameResponses(responses, fresh);
            if (testing::Test::HasFailure()) return;
            rough += fresh.roughness.rough ? 1 : 0;
            folding += std::ranges::any_of(fresh.crease.cells, [](float s) { return s > 1; }) ? 1 : 0;
        }
    }
    EXPECT_GT(folding, 50);
    EXPECT_GT(rough, 0);
}

// Sliders one after the other, most of them the crease angle: the pipeline stores folds, uses them and drops them.
TEST(StoredFolds, AWalkOfSlidersEqualsFreshRuns) {
    std::mt19937 random(7);
    sim::SimulationSettings simulation;
    simulation.lines = 90;
    simulation.beams = 140;
    const auto scan = std::make_shared<const Scan>(sim::simulate(simulation)->scan);
    Pipeline pipeline;
    Settings settings;
    for (int step = 0; step < 120; ++step) {
        const auto which = static_cast<unsigned>(random() % 12);
        if (which < 7) settings.creaseDeg = static_cast<double>(15 + random() % 76);
        if (which == 7) settings.creaseDeg = 20.25;
        if (which == 8) settings.jumpMm = static_cast<double>(10 + random() % 60);
        if (which == 9) settings.roughScans = !settings.roughScans;
        if (which == 10) settings.sensitivity = 0.3 + 0.1 * static_cast<double>(random() % 20);
        if (which == 11) settings.method = random() % 3 == 0 ? Method::Canny : Method::EdgeScanPlus;
        SCOPED_TRACE(step);
        const auto found = pipeline.run(scan, settings), fresh = detectEdges(scan, settings);
        ASSERT_EQ(*found->mask, *fresh->mask);
        if (!fresh->responses) continue;
        ASSERT_EQ(*found->classes, *fresh->classes);
        expectSameResponses(*found->responses, *fresh->responses);
        if (testing::Test::HasFailure()) return;
    }
}

} // namespace
} // namespace edgescan::edges
