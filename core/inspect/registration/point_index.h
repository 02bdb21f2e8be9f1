// Finds the nearest of many points.
#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace edgescan::inspect {

/// Points that are not finite are left out.
class PointIndex {
public:
    explicit PointIndex(std::span<const Eigen::Vector3d> points);
    PointIndex(PointIndex&&) noexcept;
    PointIndex& operator=(PointIndex&&) noexcept;
    ~PointIndex();

    /// Indices of points, nearest first, at most `count`.
    [[nodiscard]] std::vector<std::uint32_t> nearest(const Eigen::Vector3d& p, unsigned count) const;
    [[nodiscard]] std::optional<std::uint32_t> nearest(const Eigen::Vector3d& p) const;

private:
    struct Tree;
    std::unique_ptr<Tree> tree_;
    std::vector<Eigen::Vector3d> points_;
};

} // namespace edgescan::inspect
