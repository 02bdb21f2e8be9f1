// How far regions lie before their own chords (docs/rocks-method.md, "Step 7").
#pragma once

#include "core/rocks/segmentation/segments.h"

#include <span>
#include <vector>

namespace edgescan {

/// Per region -0.3 .. 0.3, positive: convex towards the scanner. `regionOfLeaf`: by leaf, below `regions`; 0 is no region.
[[nodiscard]] std::vector<double> regionBulges(const RockLeaves& leaves, std::span<const std::uint32_t> regionOfLeaf, std::size_t regions);

} // namespace edgescan
