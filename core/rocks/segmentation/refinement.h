// Borders of leaves put right by the measured ranges (docs/rocks-method.md, "Step 6").
#pragma once

#include "core/rocks/segmentation/segments.h"

namespace edgescan {

/// Leaves of fewer cells are opened, for their neighbours to take.
inline constexpr std::uint32_t kSmallestLeaf = 12;

/// 5 to 30: standard deviations off a plane beyond which more of them hardly counts. Where the beams of neighbouring cells hardly overlap,
/// a range between two surfaces is one cell's, and its neighbours know better where it belongs; where they overlap, whole strips are such.
[[nodiscard]] double mostDeviations(const AngularSteps& steps);

/// Each cell that touches another leaf goes to the one of its neighbours' leaves whose plane fits its range best, in four passes; an open
/// cell only where one fits well. Deterministic: a pass looks at what the pass before left. `most`: of mostDeviations().
void refineLeaves(const InverseRange& inverse, const DepthCracks& cracks, const RangeNoise& noise, double most, Grid<std::uint32_t>& leaf,
                  std::uint32_t count);

} // namespace edgescan
