// Figures of masks and threshold sweeps, and the truth as files.
#include "app/lab/score/evaluation.h"

#include "core/containers/png/png.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>

namespace edgescan::lab {
namespace {

namespace fs = std::filesystem;

sim::Simulation smallBell(sim::SimulationSettings& settings) {
    settings.lines = 100;
    settings.beams = 120;
    settings.seed = 9;
    settings.truth = true;
    return *sim::simulate(settings);
}

Grid<std::uint8_t> perfectMask(const sim::TruthSet& truth) {
    Grid<std::uint8_t> mask(truth.edges.edgeClass.lines, truth.edges.edgeClass.beams);
    for (std::size_t k = 0; k < mask.size(); ++k) mask[k] = truth.edges.edgeClass[k] != 0 ? 255 : 0;
    return mask;
}

TEST(Truth, SurvivesItsFiles) {
    sim::SimulationSettings settings;
    settings.rockRounding = 0.25;
    const sim::Simulation bell = smallBell(settings);
    const fs::path folder = fs::path(testing::TempDir()) / "truth-of-a-bell";
    ASSERT_TRUE(sim::writeTruth(bell, settings, folder));
    for (const char* name : {"gt_class.png", "gt_ignore.png", "object.png", "face.png", "range_clean.png", "tear_beam.png", "tear_line.png",
                             "rocks.json", "scene.json"})
        EXPECT_TRUE(fs::exists(folder / name)) << name;
    const auto scene = nlohmann::json::parse(std::ifstream(folder / "scene.json"));
    EXPECT_EQ(scene["seed"], 9);
    EXPECT_EQ(scene["rock_rounding"], 0.25);
    const Result<sim::TruthSet> read = sim::readTruth(folder);
    ASSERT_TRUE(read) << read.error().sentence();
    const sim::TruthSet made = sim::truthSetOf(bell);
    EXPECT_EQ(read->edges.edgeClass, made.edges.edgeClass);
    EXPECT_EQ(read->edges.ignore, made.edges.ignore);
    EXPECT_EQ(read->object, made.object);
    EXPECT_EQ(read->cleanMm, made.cleanMm);
    ASSERT_TRUE(containers::savePng8(Grid<std::uint8_t>(3, 4), folder / "gt_ignore.png"));
    EXPECT_FALSE(sim::readTruth(folder));
    fs::remove_all(folder);
    EXPECT_FALSE(sim::readTruth(folder));
}

TEST(Evaluation, TheTruthItselfIsPerfectInEveryFigure) {
    sim::SimulationSettings settings;
    settings.noise = 0;
    settings.footprint = false;
    const sim::Simulation bell = smallBell(settings);
    const sim::TruthSet truth = sim::truthSetOf(bell);
    const Evaluation perfect = evaluateMask(perfectMask(truth), truth, &bell.scan, 2);
    EXPECT_EQ(perfect.score.all.f(), 1.0);
    EXPECT_DOUBLE_EQ(perfect.pratt, 1.0);
    ASSERT_GE(perfect.rocks.size(), 1U);
    for (const ScoredOutline& rock : perfect.rocks) EXPECT_EQ(rock.share(), 1.0);
    const auto json = evaluationJson(perfect);
    EXPECT_LT(json["error_mm"]["p50"].get<double>(), 1.0); // ranges are whole millimetres
    EXPECT_EQ(json["rocks"]["at_least_90_percent"].get<double>(), 1.0);
}

TEST(Evaluation, PrattAgreesWithItsFormulaByBruteForce) {
    std::mt19937 random(3);
    sim::EdgeTruth truth{Grid<std::uint8_t>(25, 30), Grid<std::uint8_t>(25, 30)};
    Grid<std::uint8_t> mask(25, 30);
    for (std::size_t k = 0; k < mask.size(); ++k) {
        truth.edgeClass[k] = random() % 20 == 0 ? 1 : 0;
        truth.ignore[k] = random() % 10 == 0 ? 255 : 0;
        mask[k] = random() % 15 == 0 ? 255 : 0;
    }
    double sum = 0;
    double wanted = 0;
    double detected = 0;
    for (int k = 0; k < 750; ++k) {
        const auto at = static_cast<std::size_t>(k);
        if (truth.ignore[at] != 0) continue;
        wanted += truth.edgeClass[at] != 0 ? 1 : 0;
        if (mask[at] == 0) continue;
        ++detected;
        double nearest = 1e9;
        for (int t = 0; t < 750; ++t) {
            if (truth.edgeClass[static_cast<std::size_t>(t)] != 0)
                nearest = std::min(nearest, std::pow(k / 30 - t / 30, 2.0) + std::pow(k % 30 - t % 30, 2.0));
        }
        sum += 1 / (1 + nearest / 9);
    }
    EXPECT_NEAR(prattMerit(mask, truth), sum / std::max(wanted, detected), 1e-6);
}

TEST(Evaluation, BestThresholdsAndAreaOfASweep) {
    // Two scans, two thresholds: each scan has another best one.
    const auto counts = [](std::size_t truth, std::size_t found, std::size_t wrong) {
        Evaluation evaluation;
        evaluation.score.all = {truth, found, wrong};
        evaluation.scans = 1;
        return evaluation;
    };
    ThresholdSweep sweep;
    sweep.thresholds = {1.0, 2.0};
    sweep.perScan = {{counts(100, 90, 10), counts(100, 40, 0)}, {counts(100, 90, 90), counts(100, 80, 0)}};
    const auto json = sweepJson(sweep);
    // Threshold 1: P 180 / 280, R .9; threshold 2: P 1, R .6.
    EXPECT_DOUBLE_EQ(json["all"]["ods"].get<double>(), std::max(2 * 180.0 / (280 + 200), 2 * 120.0 / (120 + 200)));
    EXPECT_DOUBLE_EQ(json["all"]["ods_threshold"].get<double>(), 1.0);
    EXPECT_DOUBLE_EQ(json["all"]["ois"].get<double>(), 2 * 170.0 / (180 + 200));
    EXPECT_NEAR(json["all"]["ap"].get<double>(), 0.6 * 1.0 + 0.3 * 180.0 / 280, 1e-12);
}

} // namespace
} // namespace edgescan::lab
