// Matches detected edge cells with true ones: one to one, with as many pairs as possible.
#pragma once

#include "core/base/grid.h"

#include <cstdint>
#include <vector>

namespace edgescan::lab {

/// A detected cell and the true cell matched with it.
struct MatchedPair {
    std::uint32_t detected = 0; ///< k = line * beams + beam
    std::uint32_t truth = 0;
};

/// Maximum-cardinality one-to-one matching (Hopcroft and Karp 1973) of cells set in both masks (255 = edge, same shape) with a distance of
/// at most `tolerance` cells (Euclidean); near pairs are tried first. Ordered by `detected`.
[[nodiscard]] std::vector<MatchedPair> matchEdges(const Grid<std::uint8_t>& detected, const Grid<std::uint8_t>& truth, double tolerance);

} // namespace edgescan::lab
