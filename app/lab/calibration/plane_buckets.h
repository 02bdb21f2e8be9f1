// Finds the nearest of many points in a plane.
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace edgescan::inspect {

/// Points in square buckets of about eight points. Immutable, so that several threads may search at once.
class PlaneBuckets {
public:
    explicit PlaneBuckets(const std::vector<Eigen::Vector2d>& points);

    /// Indices of the `count` points nearest to `at` (of all points if there are fewer), unordered; of points at equal distance, those with
    /// lower index.
    [[nodiscard]] std::vector<std::size_t> nearest(const Eigen::Vector2d& at, std::size_t count) const;

private:
    [[nodiscard]] int column(double x) const;
    [[nodiscard]] int row(double y) const;

    std::vector<Eigen::Vector2d> points_;
    Eigen::Vector2d low_ = Eigen::Vector2d::Zero();
    double side_ = 1;
    int columns_ = 1, rows_ = 1;
    std::vector<std::size_t> order_; ///< indices of points, by bucket
    std::vector<std::size_t> first_; ///< position of each bucket in order_, and the end
};

} // namespace edgescan::inspect
