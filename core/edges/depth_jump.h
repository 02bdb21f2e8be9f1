// Jumps between neighbouring cells, measured between straight lines in inverse range (METHOD.md steps 3 and 4).
#pragma once

#include "core/edges/depth_field.h"
#include "core/edges/interlace.h"

namespace edgescan {

/// S_J of the crack between a cell and the next one, stored at the cell; over 1 is a break. 0 beside a void: where data end a rock may go
/// on (OPERATOR.md S3).
/// `slips`: steps of the stepper that a slope explains.
[[nodiscard]] PaddedGrid<float> crackJumps(const DepthField& field, Along along, const SweepSlips& slips, const DepthLimits& limits);

/// 1 where a cell and the next one belong to one surface: both solid, no break between them. Stored at the cell.
/// Nor are lines linked where the stepper slipped between them: a plane is bent there.
[[nodiscard]] PaddedGrid<float> surfaceLinks(const DepthField& field, const PaddedGrid<float>& jumps, Along along, const SweepSlips& slips);

/// S_J of the cell: that of its two cracks in which it is the nearer one.
[[nodiscard]] PaddedGrid<float> onNearerCells(const DepthField& field, const PaddedGrid<float>& jumps, Along along);

/// u += (u[-1] + u[+1] - 2u) / 4 where the cell is linked to both neighbours: planes stay planes.
void smoothSurfaces(PaddedGrid<float>& u, const PaddedGrid<float>& links, Along along);

} // namespace edgescan
