// Outlines before a void: a surface ends there, and the surface behind the missing cells is farther away (docs/method/edges.md, "Outlines
// before a void").
#pragma once

#include "core/edges/edgescan_plus/range_field.h"

#include <cstdint>
#include <vector>

namespace edgescan::edges {

/// Measured cells at the near end of a void along the beams or along the lines, ascending; the far end may be interpolated. A filled gap of
/// up to four cells is examined like a void between measured cells, because a jump may be distributed over it. An outline is certain if two
/// conditions hold. First, the straight lines in u of both ends, continued across the void, miss the other end by more than the jump
/// threshold there plus the effect of a bend of 14 degrees. Second, the near surface is slanted by 70 degrees at most, because ranges are
/// often lost on steeper surfaces. A void that reaches the border of the grid, or whose ends are on one surface, gives no outline: missing
/// data have no outline (docs/reference/rules.md, "S3").
[[nodiscard]] std::vector<std::uint32_t> silhouetteCells(const InverseRange& inverse, const AngularSteps& steps, const DepthLimits& limits);

} // namespace edgescan::edges
