// Fans that look to both sides of the axis and reach it on neither end: a line for each side.
#pragma once

#include "core/files/grid_recovery/parts.h"

namespace edgescan::files::recognition {

/// A scanner that turns round and round with several beams to one side (a spinning lidar) puts two of its lines into one plane through the
/// axis. Points in any order are found as such planes, with beams to both sides. Where both sides have the same beams, no line comes near
/// the axis and the planes cover the half turn, each plane becomes the two lines that it is, so that a line's neighbours go on all round.
/// Returns whether it was so.
bool unfoldHalves(Fit& fit);

} // namespace edgescan::files::recognition
