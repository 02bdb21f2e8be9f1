// The nearest points of a plane, compared with sorting all of them.
#include "app/lab/calibration/plane_buckets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace edgescan::inspect {

TEST(PlaneBuckets, FindsTheNearestOfAll) {
    std::mt19937 random(5);
    for (const std::size_t size : {0U, 1U, 2U, 40U, 3000U}) {
        std::vector<Eigen::Vector2d> points;
        std::normal_distribution<double> place(0.0, 0.05);
        for (std::size_t n = 0; n < size; ++n) points.emplace_back(place(random), size == 40 ? 0.0 : place(random));
        const PlaneBuckets buckets(points);
        for (int n = 0; n < 200; ++n) {
            const Eigen::Vector2d at = (n % 3 == 0 ? 10.0 : 1.0) * Eigen::Vector2d(place(random), place(random));
            for (const std::size_t count : {1U, 17U, 60U}) {
                std::vector<std::size_t> all(size);
                std::iota(all.begin(), all.end(), std::size_t{0});
                std::ranges::sort(all, {}, [&](std::size_t k) { return (points[k] - at).squaredNorm(); });
                all.resize(std::min(count, size));
                std::vector<std::size_t> found = buckets.nearest(at, count);
                std::ranges::sort(all);
                std::ranges::sort(found);
                EXPECT_EQ(found, all) << size << " " << count;
            }
        }
    }
}

} // namespace edgescan::inspect
