// The rule for "nothing measured", and scans that must not lose a point by it.
#include "core/files/point_tables/repeated_values.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace edgescan;
using namespace edgescan::files;

namespace {

constexpr int kLines = 40, kBeams = 60;

/// Directions of a grid of one degree, and ranges in them.
struct Fan {
    std::vector<double> ranges;
    [[nodiscard]] static Eigen::Vector3d direction(std::size_t k) {
        const double p = (static_cast<double>(k / kBeams) - 20) * 0.01745, a = (static_cast<double>(k % kBeams) - 30) * 0.01745;
        return {std::cos(a) * std::cos(p), std::cos(a) * std::sin(p), std::sin(a)};
    }
    [[nodiscard]] std::optional<RepeatedRange> judged(std::optional<double> stated = {}) const {
        return repeatedRange({ranges, 0, 0, direction, stated});
    }
    [[nodiscard]] std::vector<Eigen::Vector3d> points() const {
        std::vector<Eigen::Vector3d> all;
        for (std::size_t k = 0; k < ranges.size(); ++k) all.emplace_back(direction(k) * ranges[k]);
        return all;
    }
};

/// Rocks from 3 to 9 m in whole steps, where `other` gives no range of its own.
template <class Other>
Fan rocks(double step, const Other& other, unsigned seed = 1) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(3000, 9000);
    Fan fan;
    for (std::size_t k = 0; k < std::size_t{kLines} * kBeams; ++k) {
        const double range = other(k);
        fan.ranges.push_back(range > 0 ? range : std::floor(unit(random) / step) * step);
    }
    return fan;
}

/// A wall at right angles to the middle of the fan.
double wall(std::size_t k, double away, double step) { return std::round(away / Fan::direction(k).x() / step) * step; }

bool isInHole(std::size_t k) {
    const auto i = static_cast<int>(k / kBeams), j = static_cast<int>(k % kBeams);
    return std::abs(i - 20) < 3 && std::abs(j - 30) < 3;
}

} // namespace

TEST(RepeatedRange, AFarValueInManyDirectionsIsNoReturn) {
    for (const double mark : {65535.0, 81910.0, 30000.0, 200000.0}) {
        const auto found = rocks(1, [&](std::size_t k) { return k % 17 == 0 ? mark : 0; }).judged();
        ASSERT_TRUE(found) << mark;
        EXPECT_EQ(found->count, 142U);
    }
}

TEST(RepeatedRange, AStatedLimitNeedsNoDistance) {
    const Fan fan = rocks(1, [](std::size_t k) { return k % 100 == 0 ? 9300.0 : 0; });
    EXPECT_TRUE(fan.judged(9300.0));
    EXPECT_FALSE(fan.judged());
    EXPECT_FALSE(fan.judged(30000.0));
    const Fan nothing = rocks(1, [](std::size_t) { return 65535.0; });
    EXPECT_TRUE(nothing.judged(65535.0));
}

TEST(RepeatedRange, SurfacesStay) {
    // A far wall through a small hole: many cells share its rounded millimetre.
    EXPECT_FALSE(rocks(1, [](std::size_t k) { return isInHole(k) ? wall(k, 30000, 1) : 0; }).judged());
    // Numbers in whole metres or half metres.
    EXPECT_FALSE(rocks(1000, [](std::size_t k) { return k % 3 == 0 ? wall(k, 30000, 1000) : 0; }).judged());
    EXPECT_FALSE(rocks(500, [](std::size_t k) { return isInHole(k) ? wall(k, 30000, 500) : 0; }).judged());
    // A wall at one exact distance, alone, and two of them.
    Fan flat;
    flat.ranges.assign(std::size_t{kLines} * kBeams, 5000.0);
    EXPECT_FALSE(flat.judged());
    for (std::size_t k = 0; k < flat.ranges.size(); k += 2) flat.ranges[k] = 20000;
    EXPECT_FALSE(flat.judged());
    EXPECT_FALSE(flat.judged(20000.0) && flat.judged(30000.0));
    // A plane in front of the scanner, simulated without noise, and a few far cells.
    EXPECT_FALSE(rocks(1, [](std::size_t k) { return wall(k, 8000, 1); }).judged());
    EXPECT_FALSE(rocks(1, [](std::size_t k) { return k < 4 ? 30000.0 : 0; }).judged());
    // The farthest rocks reach the limit of the scanner.
    EXPECT_FALSE(rocks(50, [](std::size_t k) { return k % 100 == 0 ? 8950.0 : 0; }).judged(8950.0));
    EXPECT_FALSE(Fan{}.judged());
}

TEST(RepeatedPoints, OnePointManyTimesIsNoReturn) {
    const Eigen::Vector3d marks[]{{-9999, -9999, -9999}, {-1, -1, -1}, {999, 999, 999}, {0, 0, -9999}, {99999, 99999, 99999}};
    for (const Eigen::Vector3d& mark : marks) {
        for (const Eigen::Vector3d& shift : {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(512000, 7650000, 300)}) {
            auto points = rocks(1, [](std::size_t) { return 0; }).points();
            for (std::size_t n = 0; n < points.size(); ++n) points[n] = n % 60 == 7 ? mark : Eigen::Vector3d(points[n] * 0.001 + shift);
            const auto found = repeatedPoints(points);
            ASSERT_EQ(found.size(), 1U) << mark.transpose();
            EXPECT_EQ(found[0].point, mark);
            EXPECT_EQ(found[0].count, 40U);
        }
    }
}

TEST(RepeatedPoints, TwoMarksAndFewOfOne) {
    auto points = rocks(1, [](std::size_t) { return 0; }).points();
    for (std::size_t n = 0; n < 600; ++n) points[n] = {-1, -1, -1};
    for (std::size_t n = 700; n < 712; ++n) points[n] = {0, 0, -999999};
    EXPECT_EQ(repeatedPoints(points).size(), 2U);
    for (std::size_t n = 0; n < 600; ++n) points[n] = {static_cast<double>(n), 1, 1};
    for (std::size_t n = 703; n < 712; ++n) points[n] = {0, static_cast<double>(n), 2};
    ASSERT_EQ(repeatedPoints(points).size(), 1U); // three times, far outside
}

TEST(RepeatedPoints, ThePointOnTheAxisStays) {
    for (const double shift : {0.0, 0.4}) { // all lines look along z with their middle beam
        std::vector<Eigen::Vector3d> points;
        for (int i = 0; i < 60; ++i) {
            for (int j = -40; j <= 40; ++j) {
                const double p = i * 0.05, a = j * 0.01745;
                const Eigen::Vector3d direction(std::sin(a) * std::cos(p), std::sin(a) * std::sin(p), std::cos(a));
                points.emplace_back(j == 0 ? Eigen::Vector3d(shift, 0, 5) : Eigen::Vector3d(direction * 5 + Eigen::Vector3d(shift, 0, 0)));
            }
        }
        EXPECT_TRUE(repeatedPoints(points).empty()) << shift;
    }
}

TEST(RepeatedPoints, PointsThatShareTheirPlaceStay) {
    const Fan fan = rocks(1, [](std::size_t k) { return wall(k, 3000, 1); });
    for (const double step : {10.0, 100.0, 1000.0}) { // coordinates in centimetres, decimetres, metres
        auto points = fan.points();
        for (Eigen::Vector3d& p : points) p = (p / step).array().round() * step;
        EXPECT_TRUE(repeatedPoints(points).empty()) << step;
    }
    auto twice = fan.points();
    const auto once = twice;
    for (int n = 0; n < 8; ++n) twice.insert(twice.end(), once.begin(), once.end());
    EXPECT_TRUE(repeatedPoints(twice).empty());
    EXPECT_TRUE(repeatedPoints(std::vector<Eigen::Vector3d>(500, {1, 2, 3})).empty()); // nothing else was measured
    EXPECT_TRUE(repeatedPoints(std::vector<Eigen::Vector3d>(500, {0, 0, 0})).empty());
    EXPECT_TRUE(repeatedPoints({}).empty());
}
