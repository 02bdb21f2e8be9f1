// Noise by scale: white noise has the same value at every lag, steps that span cells do not, and folds use the measured noise.
#include "core/edges/edgescan_plus/noise_memory.h"

#include "core/edges/edgescan_plus/edgescan_plus.h"
#include "tests/support/depth_edges.h"
#include "tests/support/scans.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace edgescan::edges {
namespace {

constexpr int kNoiseLines = 300, kNoiseBeams = 340;
constexpr double kStepRad = 0.0019; // of a depth camera

// Ranges in metres of a sweep whose steps are those of a camera; `rangeM(i, j)` with its noise.
template <class Range>
InverseRange sweepOf(const Range& rangeM) {
    InverseRange inverse{Grid<float>(kNoiseLines, kNoiseBeams), Grid<Support>(kNoiseLines, kNoiseBeams, Support::Measured)};
    for (int i = 0; i < kNoiseLines; ++i) {
        for (int j = 0; j < kNoiseBeams; ++j) inverse.u.at(i, j) = static_cast<float>(1.0 / rangeM(i, j));
    }
    return inverse;
}

AngularSteps cameraLike() {
    return {std::vector<float>(kNoiseBeams, static_cast<float>(kStepRad)), std::vector<float>(kNoiseLines, static_cast<float>(kStepRad)),
            std::vector<float>(kNoiseBeams, 1.0F)};
}

// A slanted plane, 0.8 m away in the middle.
double planeM(int i, int j) { return 1.0 / (1.25 + 0.0004 * (i - 150) + 0.0003 * (j - 170)); }

// Normal noise with correlation between neighbours: the mean of `side` x `side` independent values, scaled to the size of one of them.
Grid<double> sharedNoise(int side, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    Grid<double> white(kNoiseLines + side, kNoiseBeams + side), shared(kNoiseLines, kNoiseBeams);
    for (double& value : white.cells) value = normal(random);
    for (int i = 0; i < kNoiseLines; ++i) {
        for (int j = 0; j < kNoiseBeams; ++j) {
            for (int n = 0; n < side * side; ++n) shared.at(i, j) += white.at(i + n / side, j + n % side) / side;
        }
    }
    return shared;
}

// Depth from a disparity with whole steps, as from a structured-light camera.
InverseRange cameraWall() {
    const Grid<double> noise = sharedNoise(4, 5);
    return sweepOf([&](int i, int j) {
        constexpr double kDisparityStep = 0.0025; // 1/m: 1.6 mm at 0.8 m
        const double u = 1.0 / planeM(i, j) + 0.0015 * noise.at(i, j);
        return 1.0 / (std::round(u / kDisparityStep) * kDisparityStep);
    });
}

// Standard deviation of the differences of the slopes of both sides of `reach` cells, with direct fits and direct smoothing, as the
// equivalent white noise: the value that memoryNoise() must find.
double foldNoiseByHand(const InverseRange& inverse, int reach) {
    std::vector<double> folds;
    const auto smoothed = [&](int i, int j) {
        double sum = 0;
        for (int n = 0; n < 9; ++n)
            sum += (n / 3 == 1 ? 2 : 1) * (n % 3 == 1 ? 2 : 1) / 16.0 * static_cast<double>(inverse.u.at(i + n / 3 - 1, j + n % 3 - 1));
        return sum;
    };
    const auto slope = [&](int i, int j, int way) {
        double x = 0, y = 0, xx = 0, xy = 0;
        for (int n = 0; n <= reach; ++n) {
            const double value = smoothed(i, j + way * n);
            x += n, y += value, xx += n * n, xy += n * value;
        }
        return ((reach + 1) * xy - x * y) / ((reach + 1) * xx - x * x);
    };
    for (int i = 20; i < kNoiseLines - 20; i += 3) {
        for (int j = 20; j < kNoiseBeams - 20; j += 7) folds.push_back(std::pow(slope(i, j, 1) + slope(i, j, -1), 2));
    }
    double square = 0;
    for (const double fold : folds) square += fold / static_cast<double>(folds.size());
    const double n = reach + 1;
    return 1000 * std::sqrt(square) * 0.64 / (1.41 * 0.55) * std::sqrt(n * (n * n - 1) / 12); // 0.64: r^2
}

TEST(NoiseMemory, WhiteNoiseReadsTheSameAtEveryLag) {
    const Grid<double> noise = sharedNoise(1, 3);
    const InverseRange inverse = sweepOf([&](int i, int j) { return planeM(i, j) + 0.004 * noise.at(i, j); });
    const NoiseScales scales = noiseScales(inverse, true);
    for (const double sigma : scales.sigmaMm) EXPECT_NEAR(sigma, 4.0, 0.25);
    EXPECT_NEAR(scales.nilShare, 0.04, 0.02);
    EXPECT_NEAR(scales.rangeM, 0.8, 0.02);
    EXPECT_FALSE(scales.inSteps);
    EXPECT_FALSE(scales.remembered);
    // Treated as a camera's, it nevertheless folds like white noise, which it is.
    EXPECT_NEAR(memoryNoise(inverse, cameraLike(), scales, 16).fold.at(0.8), foldNoiseByHand(inverse, 11), 0.4);
}

TEST(NoiseMemory, CoarseStepsOfWhiteNoiseHaveNone) {
    const Grid<double> noise = sharedNoise(1, 3);
    // Ranges in whole centimetres, with noise of about the same size.
    const InverseRange inverse = sweepOf([&](int i, int j) { return std::round(100 * (planeM(i, j) + 0.006 * noise.at(i, j))) / 100; });
    EXPECT_FALSE(noiseScales(inverse, true).remembered);
}

TEST(NoiseMemory, StepsThatSpanCellsAreDetected) {
    const InverseRange inverse = cameraWall();
    const NoiseScales scales = noiseScales(inverse, true);
    EXPECT_TRUE(scales.remembered);
    EXPECT_GT(scales.nilShare, 0.2);
    EXPECT_GT(scales.sigmaMm[2], 1.5 * scales.sigmaMm[0]);
    const MemoryNoise noise = memoryNoise(inverse, cameraLike(), scales, 18);
    const double byHand = foldNoiseByHand(inverse, static_cast<int>(std::lround(0.018 / 0.8 / kStepRad)));
    EXPECT_NEAR(noise.fold.at(0.8), byHand, 0.2 * byHand);
    EXPECT_GT(noise.cells, 4);
}

// The sensor's own folds are not edges; a real fold remains.
TEST(NoiseMemory, FoldsOfASteppedWallAreNoEdges) {
    const Grid<double> noise = sharedNoise(6, 8);
    const auto scan = [&](bool roof) {
        Scan made = test::makeScan(kNoiseLines, kNoiseBeams, [&](int i, int j) {
            const double fold = roof ? 0.0025 * std::abs(j - 170) : 0.0; // both sides slant by about 52 degrees
            const double u = 1.0 / planeM(i, j) - fold + 0.002 * noise.at(i, j);
            return 1000.0 / (std::round(u / 0.0025) * 0.0025);
        });
        PolarGeometry& polar = std::get<PolarGeometry>(made.geometry);
        for (int i = 0; i < kNoiseLines; ++i) polar.lineDeg[static_cast<std::size_t>(i)] = (i - 150) * kStepRad * 180 / std::numbers::pi;
        for (int j = 0; j < kNoiseBeams; ++j)
            polar.beamDeg[static_cast<std::size_t>(j)] = 90 + (j - 170) * kStepRad * 180 / std::numbers::pi;
        return made;
    };
    const auto folds = [&](const Scan& of, NoiseKind kind, int from, int to) {
        Settings settings;
        settings.noiseKind = kind;
        const DepthEdges edges = test::depthEdges(of, settings);
        std::size_t count = 0;
        for (int i = 20; i < kNoiseLines - 20; ++i) {
            for (int j = from; j < to; ++j) {
                const DepthEdge kind2 = edges.kind.at(i, j);
                count += kind2 == DepthEdge::Convex || kind2 == DepthEdge::Concave ? 1 : 0;
            }
        }
        return count;
    };
    const Scan wall = scan(false), roof = scan(true);
    const std::size_t asWhite = folds(wall, NoiseKind::Laser, 20, 320), asCamera = folds(wall, NoiseKind::Camera, 20, 320);
    EXPECT_GT(asWhite, 300U); // the white noise of neighbours underestimates it
    EXPECT_LT(10 * asCamera, asWhite);
    EXPECT_GT(folds(roof, NoiseKind::Camera, 167, 174), 200U); // of 260 lines
}

TEST(NoiseMemory, GrowthWithTheRangeOrItsSquareIsDetected) {
    const Grid<double> noise = sharedNoise(1, 9);
    for (const bool square : {false, true}) {
        const auto sigmaM = [square](double r) { return square ? 0.002 * r * r : 0.002 * r; };
        const InverseRange inverse = sweepOf([&](int i, int j) {
            const double r = 1.0 / (1.9 - 0.005 * i);
            return r + sigmaM(r) * noise.at(i, j);
        });
        const MemoryNoise found = memoryNoise(inverse, cameraLike(), noiseScales(inverse, true), 50);
        for (const double r : {0.6, 1.0, 2.0}) EXPECT_NEAR(found.range.at(r), 1000 * sigmaM(r), 150 * sigmaM(r)) << square << " " << r;
        EXPECT_EQ(found.range.perSquareMetreMm > 0, square);
    }
}

} // namespace
} // namespace edgescan::edges
