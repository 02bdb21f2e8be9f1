// Jumps between neighbouring cells, measured between straight lines in inverse range (docs/method.md, "Step 3", "Step 4"), line by line.
#pragma once

#include "core/edges/edgescan_plus/range_field.h"
#include "core/scan/angle_correction/interlace.h"

namespace edgescan {

/// crackJumps() looks at so many lines before and after its own.
inline constexpr int kJumpLooksBack = 2;
inline constexpr int kJumpLooksOn = 3;

/// The next line of `jumps`: S_J of the crack between a cell and the next one, stored at the cell; over 1 is a break. 0 beside a void,
/// because a rock may go on where data end (docs/operator.md, "S3"). Beams and lines run from -1 to their count, so that each cell has a
/// crack on both sides. `slips`: where the stepper slipped, a slanted surface looks like a step; that much is taken off.
void crackJumps(const DepthField& field, Along along, int line, const float* angle, const SweepSlips& slips, const DepthLimits& limits,
                Lines& jumps);

/// The next line of `links`, stored like the jumps: 1 where a cell and the next one belong to one surface, that is where both are solid
/// and there is no break between them. Lines between which the stepper slipped are not linked: a plane is bent there.
void surfaceLinks(const DepthField& field, const Lines& jumps, Along along, int line, const SweepSlips& slips, Links& links);

/// The next line of `cells`: S_J of the cell, the larger of its two cracks, counting only those of which it is the nearer side.
void onNearerCells(const DepthField& field, const Lines& jumps, Along along, int line, Lines& cells);

/// The next line of `smooth`: u + (u[-1] + u[+1] - 2u) / 4 where the cell is linked to both neighbours: planes stay planes.
void smoothSurfaces(const Lines& u, const Links& links, Along along, int line, Lines& smooth);

} // namespace edgescan
