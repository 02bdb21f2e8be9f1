// A sweep whose beams were interlaced or whose stepper slipped, with the angles that its own surfaces tell.
#pragma once

#include "core/scan/scan.h"

namespace edgescan {

/// The angles corrected by what core/edges/interlace.h measures: odd and even beams get half of their displacement each as a skew of the
/// line angle, lines behind a slip are moved on by it. Ranges and states stay. A warning says what was moved, or that nothing was found;
/// a slip seen in every second beam only is told and left. Clouds without beam angles stay as they are, with a warning.
[[nodiscard]] Scan straightened(Scan scan);

} // namespace edgescan
