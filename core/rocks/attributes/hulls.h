// Convex hulls of the visible points of rocks: to be drawn, never a volume (thesis 7.2).
#pragma once

#include "core/rocks/selection/rock_map.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <vector>

namespace edgescan {

/// A hull that no visible point lies outside of by more than this, metres.
inline constexpr double kHullToleranceM = 0.002;

struct RockHull {
    std::uint32_t label = 0;
    std::vector<std::uint32_t> cells;                    ///< of its corners, ascending
    std::vector<std::array<std::uint32_t, 3>> triangles; ///< places in `cells`, counter-clockwise seen from outside
};

/// By label, from 1; without triangles where the points lie in one plane.
[[nodiscard]] std::vector<RockHull> rockHulls(const RockLeaves& leaves, const RockMap& map);

} // namespace edgescan
