// Edge cells as lines: neighbours in the edge map, one after the other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace edgescan::files {

struct EdgeCell {
    std::uint32_t line = 0, beam = 0;
    float rangeMm = 0.0F;
};

/// Chains of indices into `cells`: 8-neighbours, broken where the range jumps from one to the next by more than 3 % or 50 mm, whichever
/// is more. Each link between two cells is in one chain; chains end at junctions, and closed ones repeat their first cell. A cell
/// without a neighbour is not in any.
[[nodiscard]] std::vector<std::vector<std::size_t>> chainsOf(std::span<const EdgeCell> cells);

} // namespace edgescan::files
