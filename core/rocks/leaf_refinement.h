// Borders of leaves put right by the measured ranges (docs/rocks-method.md, "Step 6").
#pragma once

#include "core/rocks/rock_leaves.h"

namespace edgescan {

/// Leaves of fewer cells are opened, for their neighbours to take.
inline constexpr std::uint32_t kSmallestLeaf = 12;

/// Each cell that touches another leaf goes to the one of its neighbours' leaves whose plane fits its range best, in four passes; an open
/// cell only where one fits well. Deterministic: a pass looks at what the pass before left.
void refineLeaves(const InverseRange& inverse, const DepthCracks& cracks, const RangeNoise& noise, Grid<std::uint32_t>& leaf,
                  std::uint32_t count);

} // namespace edgescan
