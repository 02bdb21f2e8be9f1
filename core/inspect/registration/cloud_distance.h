// How far the points of one cloud are from another cloud.
#pragma once

#include "core/inspect/registration/point_index.h"

#include <cstddef>
#include <span>
#include <vector>

namespace edgescan::inspect {

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
