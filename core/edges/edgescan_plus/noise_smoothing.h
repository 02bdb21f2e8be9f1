// Noisy ranges are smoothed along surfaces before anything is computed from them (docs/method/edges.md, "Step 1").
#pragma once

#include "core/scan/grid/inverse_range.h"

namespace edgescan::edges {

/// Moves each cell by `share` (0 to 1) of the way to the mean of itself and of pairs of cells that lie opposite each other, up to two lines
/// and beams away. A pair counts less, the more one of them differs from the cell, and not at all from three standard deviations of
/// `noise` on. So planes stay planes, and steps stay where they are. The result is the same for any number of threads.
void smoothNoise(InverseRange& inverse, const RangeNoise& noise, double share, int threads);

} // namespace edgescan::edges
