// The nearest points are those of a slow search, also among equal points and without points; distances and histogram likewise.
#include "core/inspect/registration/point_index.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using namespace edgescan::inspect;
using Eigen::Vector3d;

namespace {

constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();

/// On a coarse lattice many points are equal or equally far.
std::vector<Vector3d> someCloud(std::mt19937& dice, std::size_t count, bool lattice) {
    std::vector<Vector3d> points;
    std::uniform_real_distribution<double> place(-2, 2);
    for (std::size_t n = 0; n < count; ++n) {
        Vector3d p(place(dice), place(dice), place(dice) * 0.1);
        if (lattice) p = p.array().round();
        points.push_back(dice() % 20 == 0 ? Vector3d::Constant(kNowhere) : p);
    }
    return points;
}

std::vector<std::uint32_t> slowNearest(const std::vector<Vector3d>& points, const Vector3d& p, unsigned count) {
    std::vector<std::pair<double, std::uint32_t>> all;
    for (std::size_t n = 0; n < points.size(); ++n) {
        if (points[n].allFinite()) all.emplace_back((points[n] - p).squaredNorm(), static_cast<std::uint32_t>(n));
    }
    std::ranges::sort(all);
    std::vector<std::uint32_t> indices;
    for (std::size_t n = 0; n < std::min<std::size_t>(count, all.size()); ++n) indices.push_back(all[n].second);
    return indices;
}

} // namespace

TEST(PointIndex, FindsWhatASlowSearchFinds) {
    std::mt19937 dice(7);
    for (int round = 0; round < 60; ++round) {
        const std::vector<Vector3d> points = someCloud(dice, dice() % 400, round % 2 == 0);
        const PointIndex index(points);
        for (const Vector3d& p : someCloud(dice, 20, round % 3 == 0)) {
            if (!p.allFinite()) continue;
            for (const unsigned count : {0U, 1U, 5U, 24U, 500U}) ASSERT_EQ(index.nearest(p, count), slowNearest(points, p, count));
            const auto one = slowNearest(points, p, 1);
            ASSERT_EQ(index.nearest(p).has_value(), !one.empty());
            if (one.empty()) continue;
            ASSERT_EQ(*index.nearest(p), one.front());
            const double apart = (points[one.front()] - p).norm();
            ASSERT_EQ(index.distance(p), apart);
            ASSERT_EQ(index.distance(p, 0.5), apart <= 0.5 ? apart : std::numeric_limits<double>::infinity());
        }
    }
    EXPECT_FALSE(PointIndex({}).nearest(Vector3d::Zero()));
}

TEST(CloudDistance, IsThatOfASlowSearch) {
    std::mt19937 dice(8);
    for (const std::size_t count : {std::size_t{300}, std::size_t{60000}}) { // with one thread and with two
        const std::vector<Vector3d> points = someCloud(dice, count, false), other = someCloud(dice, 200, false);
        const std::vector<float> found = cloudDistances(points, PointIndex(other), 0.4);
        ASSERT_EQ(found.size(), points.size());
        std::size_t unknown = 0, beyond = 0;
        for (std::size_t n = 0; n < count; ++n) {
            if (!points[n].allFinite()) {
                ASSERT_TRUE(std::isnan(found[n]));
                ++unknown;
                continue;
            }
            double least = std::numeric_limits<double>::infinity();
            for (const Vector3d& p : other) {
                if (p.allFinite()) least = std::min(least, (p - points[n]).norm());
            }
            ASSERT_EQ(found[n], least <= 0.4 ? static_cast<float>(least) : std::numeric_limits<float>::infinity());
            beyond += least > 0.4 ? 1 : 0;
        }
        const DistanceHistogram histogram = distanceHistogram(found, 0.4, 8);
        EXPECT_EQ(histogram.points, count - unknown);
        EXPECT_GE(histogram.beyond, beyond);
        std::size_t all = histogram.beyond;
        for (const std::size_t each : histogram.counts) all += each;
        EXPECT_EQ(all, histogram.points);
    }
}

TEST(CloudDistance, AnEmptyCloudIsFarAway) {
    const std::vector<Vector3d> points{Vector3d::Zero()};
    EXPECT_TRUE(std::isinf(cloudDistances(points, PointIndex({}), 1.0).front()));
    EXPECT_EQ(distanceHistogram({}, 1.0, 10).points, 0U);
}
