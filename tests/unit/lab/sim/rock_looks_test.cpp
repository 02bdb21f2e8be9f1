// Lumpy and small rocks: the ranges agree with the flags, and the truth remains that of the smooth body.
#include "app/lab/sim/noise.h"
#include "app/lab/sim/random.h"
#include "app/lab/sim/simulate.h"

#include <gtest/gtest.h>

#include <cmath>

namespace edgescan::sim {
namespace {

double uniformAt(int n, int axis) {
    return 100.0 * sim::uniformOf(sim::hashOf(static_cast<std::uint64_t>(axis), sim::Purpose::Noise, static_cast<std::uint64_t>(n)));
}

SimulationSettings exactRocks() {
    SimulationSettings settings;
    settings.lines = 120;
    settings.beams = 140;
    settings.noise = 0.0;
    settings.footprint = false;
    settings.rockRoughnessMm = 0.0;
    settings.truth = true;
    return settings;
}

TEST(SimRockLooks, LumpsHaveTheirHeightAndLengthAndMoveNoOutline) {
    SimulationSettings settings = exactRocks();
    const SimulationTruth smooth = *simulate(settings)->truth;
    settings.rockLumpsMm = 20.0;
    const SimulationTruth lumpy = *simulate(settings)->truth;
    EXPECT_EQ(lumpy.object, smooth.object);
    EXPECT_EQ(lumpy.face, smooth.face);
    EXPECT_EQ(lumpy.normal.cells, smooth.normal.cells);
    double sum = 0.0;
    double squares = 0.0;
    std::size_t count = 0;
    for (int i = 0; i < smooth.object.lines; ++i) {
        for (int j = 0; j < smooth.object.beams; ++j) {
            const float relief = lumpy.cleanMm.at(i, j) - smooth.cleanMm.at(i, j);
            if (smooth.object.at(i, j) < 2) {
                EXPECT_EQ(relief, 0.0F) << "walls have no lumps";
                continue;
            }
            sum += static_cast<double>(relief);
            squares += static_cast<double>(relief) * static_cast<double>(relief);
            ++count;
        }
    }
    ASSERT_GT(count, 3000U);
    const double rms = std::sqrt(squares / static_cast<double>(count));
    EXPECT_GT(rms, 20.0);
    EXPECT_LT(rms, 40.0) << "a slant makes 20 mm at most 57";
    EXPECT_NEAR(sum / static_cast<double>(count), 0.0, 6.0);
}

TEST(SimRockLooks, ValueNoiseHasTheSpreadThatLumpsAreScaledBy) {
    double squares = 0.0;
    constexpr int kCount = 20000;
    for (int n = 0; n < kCount; ++n) {
        const Eigen::Vector3d place(uniformAt(n, 1), uniformAt(n, 2), uniformAt(n, 3));
        const double value = sim::valueNoise(place, 5);
        squares += value * value;
    }
    EXPECT_NEAR(std::sqrt(squares / kCount), sim::kValueNoiseSpread, 0.01);
}

TEST(SimRockLooks, RocksAreAsLargeAsAskedFor) {
    for (const char* scene : {"hangup", "pile"}) {
        SimulationSettings settings = exactRocks();
        settings.lines = settings.beams = 20;
        settings.scene = scene;
        const auto usual = simulate(settings)->truth->rocks;
        settings.rockSize = 0.5;
        const auto small = simulate(settings)->truth->rocks;
        ASSERT_GT(usual.size(), 420U - 1U) << scene;
        ASSERT_EQ(small.size(), usual.size());
        for (std::size_t n = 0; n < 400; ++n) EXPECT_NEAR(small[n].spansM[0], 0.5F * usual[n].spansM[0], 1e-4F) << scene << " " << n;
    }
}

} // namespace
} // namespace edgescan::sim
