// Echoes of dust close to a surface, which the look for lone cells does not see (docs/method.md, "Step 1").
#pragma once

#include "core/scan/grid/inverse_range.h"

namespace edgescan {

/// A cell that lies in front of all eight around it, or behind all of them, by 20 mm and six standard deviations at least and by more than
/// the eight lie apart, becomes a filled cell: the mean of the four beside it. Cells at the margin and beside a void stay.
void flattenSpikes(InverseRange& inverse, const RangeNoise& noise);

} // namespace edgescan
