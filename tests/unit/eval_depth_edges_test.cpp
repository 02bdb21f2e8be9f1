// Ground truth, score, and the detector that measures surfaces against straight lines in inverse range.
#include "core/edges/depth_edges.h"
#include "core/edges/pipeline.h"
#include "core/edges/presets.h"
#include "core/eval/score.h"
#include "tests/support/scans.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace edgescan {
namespace {

Simulation simulated(const char* scene, std::uint64_t seed, int lines = 250, int beams = 286) {
    SimulationSettings settings;
    settings.scene = scene;
    settings.seed = seed;
    settings.lines = lines;
    settings.beams = beams;
    settings.truth = true;
    return *simulate(settings);
}

std::size_t countOf(const EdgeTruth& truth, EdgeClass wanted) {
    return static_cast<std::size_t>(
        std::count(truth.edgeClass.cells.begin(), truth.edgeClass.cells.end(), static_cast<std::uint8_t>(wanted)));
}

TEST(EdgeTruth, AWallHasNoEdgeAndABellHasAllKinds) {
    const Simulation wall = simulated("wall", 3);
    const EdgeTruth none = edgeTruth(wall.scan, *wall.truth);
    for (const EdgeClass c : {EdgeClass::Occluding, EdgeClass::Contact, EdgeClass::Crease}) EXPECT_EQ(countOf(none, c), 0U);
    const Simulation bell = simulated("hangup", 3);
    const EdgeTruth all = edgeTruth(bell.scan, *bell.truth);
    for (const EdgeClass c : {EdgeClass::Occluding, EdgeClass::Contact, EdgeClass::Crease}) EXPECT_GT(countOf(all, c), 100U);
}

TEST(EdgeScore, TheTruthItselfIsPerfectAndNothingFindsNothing) {
    const Simulation bell = simulated("hangup", 4);
    const EdgeTruth truth = edgeTruth(bell.scan, *bell.truth);
    Grid<std::uint8_t> mask(bell.scan.lines(), bell.scan.beams());
    for (std::size_t k = 0; k < mask.size(); ++k) mask[k] = truth.edgeClass[k] != 0 ? 255 : 0;
    const EdgeScore perfect = scoreEdges(mask, truth, 2);
    EXPECT_EQ(perfect.all.f(), 1.0);
    EXPECT_EQ(perfect.crease.f(), 1.0);
    EXPECT_LT(perfect.strictOutline.precision(), 1.0); // creases are no outline
    const EdgeScore nothing = scoreEdges(Grid<std::uint8_t>(mask.lines, mask.beams), truth, 2);
    EXPECT_EQ(nothing.all.recall(), 0.0);
    EXPECT_EQ(nothing.all.f(), 0.0);
}

TEST(EdgeScore, FalseAlarmsCountOnlyWhereTheyAreScored) {
    EdgeTruth truth{Grid<std::uint8_t>(20, 20), Grid<std::uint8_t>(20, 20)};
    for (int j = 2; j < 18; ++j) truth.edgeClass.at(5, j) = static_cast<std::uint8_t>(EdgeClass::Occluding);
    Grid<std::uint8_t> mask(20, 20);
    for (int j = 2; j < 18; ++j) mask.at(6, j) = 255; // one line beside the truth
    mask.at(15, 3) = mask.at(15, 10) = 255;
    truth.ignore.at(15, 10) = 255;
    const EdgeScore score = scoreEdges(mask, truth, 2);
    EXPECT_EQ(score.occluding.found, 16U);
    EXPECT_EQ(score.occluding.false_, 1U);
    EXPECT_EQ(scoreEdges(mask, truth, 0.5).occluding.found, 0U);
}

TEST(DepthEdges, FindMoreOfTheRocksThanGrayLevelsDo) {
    EdgeScore depth;
    EdgeScore gray;
    for (const char* scene : {"hangup", "pile"}) {
        const Simulation bell = simulated(scene, 21);
        const EdgeTruth truth = edgeTruth(bell.scan, *bell.truth);
        depth += scoreEdges(depthEdges(bell.scan, {}).mask, truth, 2);
        gray += scoreEdges(*detectEdges(std::make_shared<Scan>(bell.scan), cannySettings())->mask, truth, 2);
    }
    std::printf("all edges, 286 x 250: depth edges F %.3f, gray levels F %.3f\n", depth.all.f(), gray.all.f());
    EXPECT_GT(depth.all.f(), gray.all.f() + 0.15);
    EXPECT_GT(depth.all.recall(), 0.75);
}

TEST(DepthEdges, AFlatWallWithHolesHasNone) {
    const PolarGeometry polar = test::regularAngles(200, 320);
    std::mt19937 random(2);
    std::normal_distribution<double> noise(0.0, 6.0);
    const Scan wall = test::makeScan(200, 320, [&](int i, int j) {
        const bool hole = (i > 40 && i < 90 && j > 50 && j < 150) || random() % 100 < 5;
        return hole ? 0.0 : test::wallRangeMm(polar, i, j, 5000.0) + std::round(noise(random));
    });
    const DepthEdges edges = depthEdges(wall, {});
    EXPECT_EQ(std::count(edges.mask.cells.begin(), edges.mask.cells.end(), 255), 0);
}

TEST(DepthEdges, NoiseIsFoundFromTheScanItself) {
    for (const double sigma : {4.0, 12.0}) {
        const PolarGeometry polar = test::regularAngles(150, 200);
        std::mt19937 random(7);
        std::normal_distribution<double> noise(0.0, sigma);
        const Scan wall =
            test::makeScan(150, 200, [&](int i, int j) { return test::wallRangeMm(polar, i, j, 5000.0) + std::round(noise(random)); });
        EXPECT_NEAR(rangeNoise(inverseRange(wall)).at(5.0), sigma, 0.15 * sigma);
    }
}

} // namespace
} // namespace edgescan
