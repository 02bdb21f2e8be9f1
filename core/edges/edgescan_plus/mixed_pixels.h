// Mixed pixels: the beam's spot lies on two surfaces, and the range is somewhere between them (docs/method.md, "Step 2").
#pragma once

#include "core/edges/edgescan_plus/range_field.h"

namespace edgescan {

/// snapMixedPixels() looks at so many lines before and after its own, and may write to so many after it.
inline constexpr int kMixedLooksBack = 3;
inline constexpr int kMixedLooksOn = 4;
inline constexpr int kMixedWritesOn = 1;

/// Cells that lie strictly between the straight continuations of both sides snap to the closer one. A single cell must be farther than
/// the jump threshold from both. Two beside each other snap where the spot of the beam (13 mm + 4.6 mrad, LMS511) covers both and the
/// surfaces are two thresholds apart at least. Longer runs stay: snapping them makes outlines ragged. One line of `field`; `angle`: of an
/// index step at its cells, radians. `snapped` holds a copy of the field's u, as far as may be written.
void snapMixedPixels(const DepthField& field, Along along, int line, const float* angle, const DepthLimits& limits, Lines& snapped);

} // namespace edgescan
