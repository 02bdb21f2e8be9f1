// Echoes of dust close to a surface: step 1 of the cleaning (docs/method.md, "Step 1") sees only those that are far from it.
#pragma once

#include "core/scan/inverse_range.h"

namespace edgescan {

/// A cell that lies alone in front of all eight around it, or behind them, by 20 mm and by six standard deviations at least, and by more
/// than those lie apart, becomes a filled one between them. Cells at the margin and beside a void stay.
void flattenSpikes(InverseRange& inverse, const RangeNoise& noise);

} // namespace edgescan
