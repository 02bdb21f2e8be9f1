// A stepper that still swings back at the ends of a sweep.
#include "core/scan/angle_correction/turned_steps.h"

#include "core/edges/pipeline/pipeline.h"
#include "tests/support/scans.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace edgescan {
namespace {

constexpr int kLines = 90, kBeams = 160;

// A floor 2 m below and a wall next to it, seen at a grazing angle; line i is measured at the angle of `place(i)`.
Scan corridor(const std::function<double(int)>& place) {
    const PolarGeometry polar = test::regularAngles(kLines, kBeams);
    std::mt19937 random(5);
    std::normal_distribution<double> noise(0.0, 3.0);
    return test::makeScan(kLines, kBeams, [&](int i, int j) {
        const double p = (50.0 + 0.25 * place(i)) * std::numbers::pi / 180;
        const double a = polar.beamDeg[static_cast<std::size_t>(j)] * std::numbers::pi / 180;
        const double floor = 2000.0 / (std::sin(a) * std::cos(p));
        const double wall = a > std::numbers::pi / 2 ? 2600.0 / (std::sin(a) * std::cos(p) + 0.9 * (a - std::numbers::pi / 2)) : 1e9;
        return std::round(std::min(floor, wall) + noise(random));
    });
}

double even(int i) { return i; }
// Back for four lines, then to its speed within three.
double turnedFirst(int i) {
    constexpr double kPlaces[]{4, 3, 2, 1.2, 1, 1.2};
    return i < 6 ? kPlaces[i] : 2 + (i - 6);
}
double turnedLast(int i) { return kLines - 1 - turnedFirst(kLines - 1 - i); }

std::ptrdiff_t turnedOf(const Scan& scan) {
    const auto turned = turnedSteps(inverseRange(scan));
    return std::ranges::count(turned, std::uint8_t{1});
}

TEST(TurnedSteps, AreFoundAtBothEndsAndNowhereElse) {
    EXPECT_TRUE(turnedSteps(inverseRange(corridor(even))).empty());
    const auto first = turnedSteps(inverseRange(corridor(turnedFirst))), last = turnedSteps(inverseRange(corridor(turnedLast)));
    ASSERT_EQ(first.size(), static_cast<std::size_t>(kLines));
    ASSERT_EQ(last.size(), static_cast<std::size_t>(kLines));
    for (int i = 0; i < kLines; ++i) {
        if (i < 4 || i > 5) {
            EXPECT_EQ(first[static_cast<std::size_t>(i)], i < 4 ? 1 : 0) << i;
        }
        const int step = kLines - 2 - i;
        if (step >= 0 && (i < 4 || i > 5)) {
            EXPECT_EQ(last[static_cast<std::size_t>(step)], i < 4 ? 1 : 0) << step;
        }
    }
}

TEST(TurnedSteps, AStallASlowStartOrARidgeOfOneSurfaceIsNone) {
    EXPECT_EQ(turnedOf(corridor([](int i) { return i < 4 ? 3.0 : even(i); })), 0) << "the stepper stood still";
    EXPECT_EQ(turnedOf(corridor([](int i) { return i < 6 ? 3 + 0.5 * i : even(i); })), 0) << "it was slow";
    Scan ridge = corridor(even);
    for (int i = 0; i < 5; ++i) {
        for (int j = 60; j < 75; ++j) ridge.rangeMm.at(i, j) = ridge.rangeMm.at(10 - i, j);
    }
    EXPECT_EQ(turnedOf(ridge), 0);
}

TEST(TurnedSteps, TheFoldAcrossThemIsNoEdge) {
    const auto scan = std::make_shared<const Scan>(corridor(turnedFirst));
    const auto edgesAt = [](const edges::Detection& detection) {
        return std::ranges::count_if(*detection.edges, [](std::uint32_t k) { return k < 10 * kBeams; });
    };
    edges::Settings settings;
    const auto allowed = edgesAt(*edges::detectEdges(scan, settings));
    settings.turns = false;
    const auto drawn = edgesAt(*edges::detectEdges(scan, settings));
    EXPECT_GT(drawn, allowed + kBeams / 2) << "without it a fold runs across the surfaces";
    EXPECT_LT(allowed, 20);
}

} // namespace
} // namespace edgescan
