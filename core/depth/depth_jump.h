// Jumps between neighbouring cells, measured between straight lines in inverse range (docs/method.md, "Step 3", "Step 4"), line by line.
#pragma once

#include "core/depth/depth_field.h"
#include "core/straighten/interlace.h"

namespace edgescan {

/// How many lines before and after its own crackJumps() looks at.
inline constexpr int kJumpLooksBack = 2;
inline constexpr int kJumpLooksOn = 3;

/// The next line of `jumps`: S_J of the crack between a cell and the next one, stored at the cell; over 1 is a break. 0 beside a void:
/// where data end a rock may go on (docs/operator.md, "S3"). Beams from -1 to their count are written, and there are lines from -1 to their
/// count.
/// `slips`: steps of the stepper that a slope explains.
void crackJumps(const DepthField& field, Along along, int line, const float* angle, const SweepSlips& slips, const DepthLimits& limits,
                Lines& jumps);

/// The next line of `links`, as far as that of the jumps: 1 where a cell and the next one belong to one surface, both solid and no break
/// between them. Stored at the cell. Nor are lines linked where the stepper slipped between them: a plane is bent there.
void surfaceLinks(const DepthField& field, const Lines& jumps, Along along, int line, const SweepSlips& slips, Lines& links);

/// The next line of `cells`: S_J of the cell, that of its two cracks in which it is the nearer one.
void onNearerCells(const DepthField& field, const Lines& jumps, Along along, int line, Lines& cells);

/// The next line of `smooth`: u + (u[-1] + u[+1] - 2u) / 4 where the cell is linked to both neighbours: planes stay planes.
void smoothSurfaces(const Lines& u, const Lines& links, Along along, int line, Lines& smooth);

} // namespace edgescan
