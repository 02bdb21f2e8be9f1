// Finds the nearest of many points.
#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace edgescan::inspect {

/// A tree that halves its points at each node. Points that are not finite are left out.
class PointIndex {
public:
    explicit PointIndex(std::span<const Eigen::Vector3d> points);

    /// Indices of points, nearest first, at most `count`. Of points at equal distance the one with the lowest index comes first.
    [[nodiscard]] std::vector<std::uint32_t> nearest(const Eigen::Vector3d& p, unsigned count) const;
    [[nodiscard]] std::optional<std::uint32_t> nearest(const Eigen::Vector3d& p) const;
    /// Of the nearest point; infinite if none is within `mostM`.
    [[nodiscard]] double distance(const Eigen::Vector3d& p, double mostM = std::numeric_limits<double>::infinity()) const;

private:
    /// Of `count` points from `first`. An inner node is followed by its lower half; `upper` is the index of the upper half.
    struct Node {
        std::uint32_t first = 0, count = 0;
        std::uint32_t upper = 0; ///< 0: an end node
        int axis = 0;
        double split = 0.0;
    };
    void halve(std::uint32_t first, std::uint32_t count, std::span<const Eigen::Vector3d> points);
    /// Calls visit(first, count) for each end node that may hold a point within the square of limit(), the nearer ones first.
    template <class Visit, class Limit>
    void search(const Eigen::Vector3d& p, Visit visit, Limit limit) const;

    std::vector<Node> nodes_;
    std::vector<std::uint32_t> order_;     ///< indices of points, by end nodes
    std::vector<Eigen::Vector3d> ordered_; ///< the points in that order
};

} // namespace edgescan::inspect
