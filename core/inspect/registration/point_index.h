// Finds the nearest of many points.
#pragma once

#include <Eigen/Core>

#include <cstddef>
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

/// Metres from each point to the nearest one of the other cloud: NaN for a point that is not finite, infinite where none is within `mostM`.
/// It is never below the distance of the surfaces by more than half the spacing of the other cloud's points.
[[nodiscard]] std::vector<float> cloudDistances(std::span<const Eigen::Vector3d> points, const PointIndex& other, double mostM);

/// Counts of distances in equal steps from 0.
struct DistanceHistogram {
    double stepM = 0.0;
    std::vector<std::size_t> counts; ///< distance d is counted at index floor(d / stepM)
    std::size_t beyond = 0;          ///< farther than the last step
    std::size_t points = 0;          ///< all that were measured
    double medianM = 0.0;            ///< infinite if most are beyond every distance measured
};
[[nodiscard]] DistanceHistogram distanceHistogram(std::span<const float> distances, double mostM, int steps);

} // namespace edgescan::inspect
