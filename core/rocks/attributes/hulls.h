// Convex hulls of the visible points of rocks: only for display, never a volume (thesis 7.2).
#pragma once

#include "core/rocks/selection/rock_map.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <vector>

namespace edgescan::rocks {

/// Largest distance of a visible point outside of the hull, metres.
inline constexpr double kHullToleranceM = 0.002;

struct Hull {
    std::uint32_t label = 0;
    std::vector<std::uint32_t> cells;                    ///< cells of its corners, ascending
    std::vector<std::array<std::uint32_t, 3>> triangles; ///< indices of `cells`, counter-clockwise as seen from outside
};

/// By label, from 1; without triangles if the points are in one plane.
[[nodiscard]] std::vector<Hull> rockHulls(const Segmentation& segments, const RegionMap& map);

} // namespace edgescan::rocks
