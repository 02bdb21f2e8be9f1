// Rough scans: the shares of folding cells, counted slowly, and what they change.
#include "core/edges/edgescan_plus/roughness.h"

#include "app/lab/sim/simulate.h"
#include "core/edges/explain/why.h"
#include "core/edges/pipeline/pipeline.h"
#include "core/edges/settings/presets.h"
#include "core/rocks/segmentation/barrier.h"
#include "tests/support/scans.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace edgescan::edges {
namespace {

AngularSteps evenSteps(int lines, int beams, float rad) {
    return {std::vector<float>(static_cast<std::size_t>(beams), rad), std::vector<float>(static_cast<std::size_t>(lines), rad),
            std::vector<float>(static_cast<std::size_t>(beams), 1.0F)};
}

// Pyramids of 60 mm of relief and 200 mm from one to the next on a wall 4 m away: it folds everywhere.
std::shared_ptr<const Scan> pyramids() {
    constexpr int kLines = 160, kBeams = 200;
    const PolarGeometry polar = test::regularAngles(kLines, kBeams);
    std::mt19937 random(4);
    std::normal_distribution<double> noise(0.0, 4.0);
    return std::make_shared<const Scan>(test::makeScan(kLines, kBeams, [&](int i, int j) {
        const auto wave = [](double n) { return std::abs(std::fmod(n, 12.0) - 6.0) / 6.0; };
        return test::wallRangeMm(polar, i, j, 4000.0 - 120.0 * (wave(i) + wave(j))) + std::round(noise(random));
    }));
}

TEST(Roughness, SharesAreThoseOfCountingEachCell) {
    constexpr int kLines = 70, kBeams = 150;
    std::mt19937 random(11);
    Grid<float> alongBeams(kLines, kBeams), alongLines(kLines, kBeams);
    Grid<Support> support(kLines, kBeams, Support::Measured);
    for (std::size_t k = 0; k < support.size(); ++k) {
        alongBeams[k] = static_cast<float>(random() % 200) / 100.0F - 1.0F;
        alongLines[k] = static_cast<float>(random() % 160) / 100.0F - 0.8F;
        if (random() % 5 == 0) support[k] = Support::Void;
    }
    FoldingCells cells(kLines, kBeams);
    for (int i = kLines - 1; i >= 0; --i) cells.note(i, alongBeams.line(i), alongLines.line(i), support.line(i));
    const AngularSteps steps = evenSteps(kLines, kBeams, 0.0125F); // 21 cells reach 15 degrees
    const Grid<float> u(kLines, kBeams, 0.25F);                    // 4 m: points are 50 mm apart
    const Roughness found = roughnessOf(cells, u, steps, alongBeams, 0.5);
    double folding = 0, solid = 0;
    const auto folds = [&](int i, int j) { return std::max(std::abs(alongBeams.at(i, j)), std::abs(alongLines.at(i, j))) > 0.35F; };
    for (int i = 0; i < kLines; ++i) {
        for (int j = 0; j < kBeams; ++j) {
            if (support.at(i, j) == Support::Void) continue;
            ++solid;
            folding += folds(i, j) ? 1 : 0;
        }
    }
    EXPECT_DOUBLE_EQ(found.share, folding / solid);
    ASSERT_TRUE(found.rough);
    EXPECT_FALSE(roughnessOf(cells, u, steps, alongBeams, 1.2).rough) << "folds that noise alone may look like";
    const Grid<float> far(kLines, kBeams, 0.15F); // 83 mm
    EXPECT_FALSE(roughnessOf(cells, far, steps, alongBeams, 0.5).rough) << "points so far apart that every rock folds";
    // Groups of 16 beams, one to each side.
    for (const auto& [line, beam] : {std::pair{0, 0}, {35, 70}, {69, 149}, {10, 100}}) {
        const int group = beam / Roughness::kGroup;
        double around = 0, all = 0;
        for (int i = std::max(0, line - 21); i <= std::min(kLines - 1, line + 21); ++i) {
            for (int j = std::max(0, (group - 1) * Roughness::kGroup); j < std::min(kBeams, (group + 2) * Roughness::kGroup); ++j) {
                if (support.at(i, j) == Support::Void) continue;
                ++all;
                around += folds(i, j) ? 1 : 0;
            }
        }
        EXPECT_FLOAT_EQ(found.aroundAt(line, beam), static_cast<float>(around / all)) << line << " " << beam;
    }
}

TEST(Roughness, OnlyAScanThatFoldsEverywhereIsRough) {
    const auto smooth = std::make_shared<const Scan>(test::boxesScan(120, 160, 4));
    Settings off = defaultSettings(4);
    off.roughScans = false;
    const auto boxes = detectEdges(smooth, defaultSettings(4)), same = detectEdges(smooth, off);
    EXPECT_FALSE(boxes->responses->roughness.rough);
    EXPECT_EQ(boxes->responses->crease, same->responses->crease);
    EXPECT_EQ(*boxes->mask, *same->mask);
}

// Rocks of a few cells fold everywhere: nothing says then that their surfaces are rough.
TEST(Roughness, ACoarseScanOfRocksIsNotRough) {
    for (const std::uint64_t seed : {5U, 77U}) {
        sim::SimulationSettings options;
        options.seed = seed;
        options.lines = 100;
        options.beams = 120;
        const auto scan = std::make_shared<const Scan>(sim::simulate(options)->scan);
        const auto detection = detectEdges(scan, defaultSettings(4));
        EXPECT_FALSE(detection->responses->roughness.rough) << seed << " " << detection->responses->roughness.aroundFolds;
    }
}

TEST(Roughness, OnARoughScanFoldsLoseAndRocksDoNot) {
    const auto scan = pyramids();
    Settings off = defaultSettings(4);
    off.roughScans = false;
    const auto on = detectEdges(scan, defaultSettings(4), KeepFor::Rocks), without = detectEdges(scan, off, KeepFor::Rocks);
    const Roughness& found = on->responses->roughness;
    ASSERT_TRUE(found.rough) << found.aroundFolds << " " << found.share;
    EXPECT_LT(2 * on->edges->size(), without->edges->size());
    EXPECT_EQ(*on->responses->jump, *without->responses->jump);
    EXPECT_EQ(on->responses->unweighed, without->responses->crease);
    for (std::size_t k = 0; k < scan->cells(); ++k) {
        ASSERT_EQ(rocks::separationStrength(*on->responses, k), rocks::separationStrength(*without->responses, k));
        const auto beams = static_cast<std::size_t>(scan->beams());
        const float factor = found.factorAt(static_cast<int>(k / beams), static_cast<int>(k % beams));
        ASSERT_GE(factor, 1.0F);
        ASSERT_EQ(on->responses->crease[k], without->responses->crease[k] / factor);
    }
}

TEST(Roughness, TheReasonOfACellGivesTheShare) {
    const auto scan = pyramids();
    const auto detection = detectEdges(scan, defaultSettings(4));
    ASSERT_TRUE(detection->responses->roughness.rough);
    int reasons = 0;
    for (std::size_t k = 0; k < scan->cells(); k += 97) {
        if (!(std::abs(detection->responses->unweighed[k]) > 0.7F)) continue;
        const Why why = whyCell(*detection, k);
        ASSERT_TRUE(why.rough);
        EXPECT_NE(whyText(why, detection->settings).find("% of what is within 15 degrees folds"), std::string::npos);
        EXPECT_FALSE(why.movedFromGap);
        ++reasons;
    }
    EXPECT_GT(reasons, 5);
}

} // namespace
} // namespace edgescan::edges
