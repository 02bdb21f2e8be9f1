// Mixed pixels: the beam's spot lies on two surfaces, and the range is somewhere between them (METHOD.md step 2).
#pragma once

#include "core/edges/depth_field.h"

namespace edgescan {

/// Cells that lie strictly between the straight continuations of both sides snap to the closer one. A single cell must be farther than
/// the jump threshold from both; runs of two or three are taken where the spot of the beam (13 mm + 4.6 mrad, LMS511) covers them, and
/// where the surfaces are two thresholds apart at least. `inverse` tells measured cells from filled ones.
void snapVeils(DepthField& field, const InverseRange& inverse, const AngularSteps& steps, Along along, const DepthLimits& limits);

} // namespace edgescan
