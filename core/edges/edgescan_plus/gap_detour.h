// Edges that run on across cells without a range.
#pragma once

#include "core/scan/grid/inverse_range.h"

namespace edgescan {

/// Moves each response of a filled cell to a measured cell beside it, so that an edge goes round a lost range and every edge cell has a
/// point: a jump to the nearest surface, a fold to the range most alike. A cell that has a response of that kind already is not taken;
/// where no cell is left, the response is dropped. `jump`, `crease`: lines x beams, 0 = none.
void goRoundGaps(const InverseRange& inverse, Grid<float>& jump, Grid<float>& crease);

} // namespace edgescan
