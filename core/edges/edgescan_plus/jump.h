// Jumps between neighbouring cells, measured between straight lines in inverse range (docs/method/edges.md, "Step 3", "Step 4"), line by
// line.
#pragma once

#include "core/edges/edgescan_plus/range_field.h"
#include "core/scan/angle_correction/interlace.h"

namespace edgescan::edges {

/// Number of lines before and after its own that crackJumps() reads.
inline constexpr int kJumpLinesBefore = 2;
inline constexpr int kJumpLinesAfter = 3;

/// Computes the next line of `jumps`: S_J of the crack between a cell and the next one, stored at the cell; above 1 it is a break. 0 next
/// to a void, because a rock may continue where the data end (docs/reference/rules.md, "S3"). Beams and lines run from -1 to their count,
/// so that each cell has a crack on both sides. `slips`: where the stepper slipped, a slanted surface looks like a step; this step is
/// subtracted.
void crackJumps(const DepthField& field, Along along, int line, const float* angle, const SweepSlips& slips, const DepthLimits& limits,
                Lines& jumps);

/// Computes the next line of `links`, stored like the jumps: 1 where a cell and the next one belong to one surface, which means that both
/// are solid and there is no break between them. Lines between which the stepper slipped are not linked, because a plane is bent there.
void surfaceLinks(const DepthField& field, const Lines& jumps, Along along, int line, const SweepSlips& slips, Links& links);

/// Computes the next line of `cells`: S_J of the cell, the larger of its two cracks. Only cracks count of which the cell is the nearer
/// side.
void jumpsOnNearerCells(const DepthField& field, const Lines& jumps, Along along, int line, Lines& cells);

/// Computes the next line of `smooth`: u + share (u[-1] + u[+1] - 2u) / 4 where the cell is linked to both neighbours. Planes stay planes.
void smoothSurfaces(const Lines& u, const Links& links, Along along, int line, float share, Lines& smooth);

} // namespace edgescan::edges
