// Outlines before a void: where a surface ends and what lies behind the missing cells is farther away (docs/method.md, "Outlines before a
// void").
#pragma once

#include "core/edges/edgescan_plus/range_field.h"

#include <cstdint>
#include <vector>

namespace edgescan {

/// Measured cells at the near end of a void along the beams or along the lines, ascending; the far end may be interpolated. A gap of up to
/// four cells that was filled is looked at like a void, between measured cells: a jump may be spread over it. Certain means:
/// the straight lines in u of both ends, continued across the void, miss the other end by the jump threshold there and what a bend of 14
/// degrees on the way would make; and the near surface does not slant away by more than 70 degrees, where ranges get lost by themselves. A
/// void that reaches the border of the grid, or whose ends lie on one surface, tells nothing: missing data have no outline
/// (docs/operator.md, "S3").
[[nodiscard]] std::vector<std::uint32_t> silhouetteCells(const InverseRange& inverse, const AngularSteps& steps, const DepthLimits& limits);

} // namespace edgescan
