// The nearest of many points in a plane.
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace edgescan {

/// Points put into square buckets of about eight. Never changes, so any number of threads may ask.
class PlaneBuckets {
public:
    explicit PlaneBuckets(const std::vector<Eigen::Vector2d>& points);

    /// Indices of the `count` points nearest to `at` (all where there are fewer), in no order; of points equally far those of lower index.
    [[nodiscard]] std::vector<std::size_t> nearest(const Eigen::Vector2d& at, std::size_t count) const;

private:
    [[nodiscard]] int column(double x) const;
    [[nodiscard]] int row(double y) const;

    std::vector<Eigen::Vector2d> points_;
    Eigen::Vector2d low_ = Eigen::Vector2d::Zero();
    double side_ = 1;
    int columns_ = 1, rows_ = 1;
    std::vector<std::size_t> order_; ///< indices by bucket
    std::vector<std::size_t> first_; ///< of each bucket in order_, and the end
};

} // namespace edgescan
