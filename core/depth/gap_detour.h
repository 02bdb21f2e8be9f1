// Edges that run on across cells without a range.
#pragma once

#include "core/scan/inverse_range.h"

namespace edgescan {

/// Moves each response of a filled cell to a measured cell beside it, so that a line of edge cells goes round a lost range and every edge
/// cell has a point: a jump to the nearest surface, a fold to the range most alike. Only to cells without a response of the kind; where
/// there is none, the response is dropped. `jump`, `crease`: lines x beams, 0 = none.
void goRoundGaps(const InverseRange& inverse, Grid<float>& jump, Grid<float>& crease);

} // namespace edgescan
