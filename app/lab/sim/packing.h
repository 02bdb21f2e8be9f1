// Jamming: balls, which represent rocks, are pushed apart until they touch.
#pragma once

#include "app/lab/sim/random.h"

#include <Eigen/Core>

#include <functional>
#include <vector>

namespace edgescan::sim {

struct Ball {
    Eigen::Vector3d centre = Eigen::Vector3d::Zero(); ///< metres
    double radius = 0.5;
};

/// Moves a ball back into the allowed space.
using Confine = std::function<void(std::size_t index, Ball& ball)>;

/// Alternates between pushing overlapping balls apart and confining each ball; small balls give way to large ones. The cost grows with the
/// square of the number of balls. @param touch distance at which two balls come to rest, as a share of the sum of their radii; below 1 they
/// stay interlocked
[[nodiscard]] std::vector<Ball> relaxed(std::vector<Ball> balls, const Confine& confine, double touch, int rounds);

/// Balls with the given radii. Of twelve random places, each ball takes the one farthest from the balls before it, so that the large ones,
/// which come first, do not hide behind each other.
[[nodiscard]] std::vector<Ball> scattered(const std::vector<double>& radii, const std::function<Eigen::Vector3d(RandomSequence&)>& place,
                                          RandomSequence& dice);

} // namespace edgescan::sim
