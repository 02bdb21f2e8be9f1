// Broken rock: angular convex polyhedra.
#pragma once

#include "app/lab/sim/random.h"
#include "app/lab/sim/scene.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace edgescan::sim {

/// Longest axes of rocks in metres, largest first: log-normal between 0.16 and 2.6; with more than forty rocks also a few keystones.
[[nodiscard]] std::vector<double> rockSizes(int count, std::uint64_t seed);

/// Radius of the ball that represents a rock of this size during packing.
[[nodiscard]] std::vector<double> ballRadii(const std::vector<double>& sizesM);

/// Corners of a rock around the origin: 12-40 points, longest axis `sizeM`, the two others 0.55-1 of it, in a random orientation.
[[nodiscard]] std::vector<Eigen::Vector3d> rockCorners(double sizeM, RandomSequence& dice);

/// Adds the hull of the corners, moved to `centreM`, as the scene's next rock. Each flat side becomes a face, numbered from 1, then each
/// rounded ridge. Corners in one plane add nothing. @param rounding radius of its corners and ridges as a share of the largest ball around
/// its middle that fits inside, from 0 to below 1
void addRock(Scene& scene, const std::vector<Eigen::Vector3d>& corners, const Eigen::Vector3d& centreM, double rounding = 0.0);

/// The longest distance between two corners, then the widths across it: the largest one, and the one at right angles to both.
[[nodiscard]] std::array<double, 3> spansOf(const std::vector<Eigen::Vector3d>& cornersM);

/// Adds a box with faces 1-6 (-x, +x, -y, +y, -z, +z) as object `object`.
void addBox(Scene& scene, const Eigen::AlignedBox3d& box, std::uint16_t object);

} // namespace edgescan::sim
