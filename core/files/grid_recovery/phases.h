// Lines that were measured with beams of different phases, one after the other in turn, make one line of all these beams.
#pragma once

#include "core/files/grid_recovery/recover_grid.h"

namespace edgescan::files::recognition {

/// Puts two to eight lines that follow each other side by side where each of them has every so many beams only, the next one those next to
/// them, in turn over the whole grid; each beam keeps the angle of its line as its skew. Returns how many lines make one, 1 when nothing
/// was changed.
int foldPhases(RecoveredGrid& grid);

} // namespace edgescan::files::recognition
