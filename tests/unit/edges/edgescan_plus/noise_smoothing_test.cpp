// Noisy ranges are smoothed, and the shape of the surface stays.
#include "core/edges/edgescan_plus/noise_smoothing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace edgescan::edges {
namespace {

constexpr int kPlaneLines = 40, kPlaneBeams = 60;
constexpr RangeNoise kNoise{20, 0, 0};

// Two planes in u at 5 m that are `stepMm` apart from the middle beam on, with noise.
InverseRange twoPlanes(double stepMm, double noiseMm) {
    std::mt19937 random(5);
    InverseRange planes{Grid<float>(kPlaneLines, kPlaneBeams), Grid<Support>(kPlaneLines, kPlaneBeams, Support::Measured)};
    for (int i = 0; i < kPlaneLines; ++i) {
        for (int j = 0; j < kPlaneBeams; ++j) {
            const double error = noiseMm * (static_cast<double>(random() % 20001) / 10000.0 - 1.0) * std::sqrt(3.0);
            const double u = 0.2 + 1e-5 * i - 2e-5 * j - 0.04 * 0.001 * ((j < kPlaneBeams / 2 ? 0.0 : stepMm) + error);
            planes.u.at(i, j) = static_cast<float>(u);
        }
    }
    return planes;
}

double rmsAgainst(const InverseRange& a, const InverseRange& b) {
    double sum = 0;
    for (std::size_t k = 0; k < a.u.size(); ++k) sum += std::pow(static_cast<double>(a.u[k]) - static_cast<double>(b.u[k]), 2);
    return std::sqrt(sum / static_cast<double>(a.u.size())) / 0.04 / 0.001; // mm
}

TEST(NoiseSmoothing, PlanesAndStepsOfThreeDeviationsStay) {
    for (const double step : {0.0, 60.0, 500.0}) {
        const InverseRange before = twoPlanes(step, 0);
        InverseRange after = before;
        smoothNoise(after, kNoise, 1, 1);
        EXPECT_LT(rmsAgainst(after, before), 0.01) << step;
    }
}

TEST(NoiseSmoothing, AThirdOfTheNoiseGoes) {
    const InverseRange clean = twoPlanes(500, 0), noisy = twoPlanes(500, 20);
    InverseRange smooth = noisy, half = noisy;
    smoothNoise(smooth, kNoise, 1, 1);
    smoothNoise(half, kNoise, 0.5, 1);
    EXPECT_NEAR(rmsAgainst(noisy, clean), 20, 1);
    EXPECT_LT(rmsAgainst(smooth, clean), 14);
    EXPECT_LT(rmsAgainst(half, clean), rmsAgainst(noisy, clean));
    EXPECT_LT(rmsAgainst(smooth, clean), rmsAgainst(half, clean));
}

TEST(NoiseSmoothing, VoidsMoveNothingAndStay) {
    InverseRange before = twoPlanes(0, 0);
    for (int i = 0; i < kPlaneLines; ++i) {
        before.support.at(i, 20) = Support::Void;
        before.u.at(i, 20) = before.u.at(i, 19) * 1.0001F;
    }
    InverseRange after = before;
    smoothNoise(after, kNoise, 1, 1);
    for (std::size_t k = 0; k < before.u.size(); ++k) EXPECT_NEAR(after.u[k], before.u[k], 1e-7F) << k;
    EXPECT_EQ(after.u.at(3, 20), before.u.at(3, 20));
}

TEST(NoiseSmoothing, ThreadsAndGridsOfAnySize) {
    InverseRange one = twoPlanes(100, 20), three = one;
    smoothNoise(one, kNoise, 1, 1);
    smoothNoise(three, kNoise, 1, 3);
    EXPECT_EQ(one.u.cells, three.u.cells);
    for (const auto& [lines, beams] : {std::pair{1, 1}, {1, 9}, {9, 1}, {3, 3}, {2, 5}}) {
        InverseRange small{Grid<float>(lines, beams, 0.2F), Grid<Support>(lines, beams, Support::Measured)};
        smoothNoise(small, kNoise, 1, 2);
        for (std::size_t k = 0; k < small.u.size(); ++k) EXPECT_FLOAT_EQ(small.u[k], 0.2F);
    }
}

} // namespace
} // namespace edgescan::edges
