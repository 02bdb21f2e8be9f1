// Removes echoes of dust close to a surface, which isolatedCells() does not find (docs/method/edges.md, "Step 1").
#pragma once

#include "core/scan/grid/inverse_range.h"

namespace edgescan {

/// A cell in front of all eight cells around it, or behind all of them, becomes a filled cell: the mean of its four direct neighbours. The
/// distance must be at least 20 mm, at least six standard deviations, and more than the spread of the eight. Cells at the margin and next
/// to a void are unchanged.
void removeSpikes(InverseRange& inverse, const RangeNoise& noise);

} // namespace edgescan
