// Edges that continue across cells without a range.
#pragma once

#include "core/scan/grid/inverse_range.h"

namespace edgescan::edges {

/// Moves each response of a filled cell to a measured cell next to it, so that an edge goes around a lost range and every edge cell has a
/// point. A jump is moved to the nearest surface, a fold to the most similar range. A cell that already has a response of that kind is not
/// used. If all cells have one, the response is dropped. Grids: lines x beams, 0 = no response.
void moveJumpsOffGaps(const InverseRange& inverse, Grid<float>& jump);
void moveFoldsOffGaps(const InverseRange& inverse, Grid<float>& crease);

} // namespace edgescan::edges
