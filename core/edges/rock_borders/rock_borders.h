// How likely an edge is the border of a rock, and not a fold within one (docs/method/edges.md, "Rock border or fold").
#pragma once

#include "core/base/boosted_trees.h"
#include "core/edges/rock_borders/border_features.h"

#include <cstdint>
#include <span>
#include <vector>

namespace edgescan::edges {

/// Probability in per cent, 0 to 100, or kUnknownBorder: near the end of the grid, beyond 60 m, where no range was
/// measured, and in scans whose neighbours err alike (depth cameras).
using BorderPercent = std::uint8_t;
inline constexpr BorderPercent kUnknownBorder = 255;
inline constexpr BorderPercent kStrongBorder = 70, kWeakBorder = 30; ///< from here on drawn as a border; below as a fold

/// Of these cells, in their order. Outlines before a void and rims of voids that are edges have 100; of a data border, which is not an edge
/// of anything, nothing is known. The same for any number of threads.
[[nodiscard]] std::vector<BorderPercent> borderPercents(const DepthSurface& surface, const DepthResponses& responses,
                                                        const Settings& settings, std::span<const std::uint32_t> cells, int threads = 1);

/// The kinds of evidence that moved the probability of a cell, the strongest first, in kLogOddsUnit: positive for a border. Empty where
/// the probability is unknown.
struct BorderReason {
    BorderEvidence evidence = BorderEvidence::Steps;
    std::int32_t added = 0;
};
[[nodiscard]] std::vector<BorderReason> borderReasons(const DepthSurface& surface, const DepthResponses& responses,
                                                      const Settings& settings, std::size_t cell);

/// The trees that `edgescan-lab learn-edges` made.
struct BorderModel {
    std::int32_t start = 0; ///< log odds before the first tree
    std::span<const BoostedTree> trees;
};
[[nodiscard]] BorderModel borderModel();

} // namespace edgescan::edges
