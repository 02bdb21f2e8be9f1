// Suppression: of neighbours across an edge only the strongest response remains (docs/method/edges.md, "Step 6").
#pragma once

#include "core/base/simd.h"

#include <cmath>

namespace edgescan::edges {

/// In the direction of the stronger response a cell must not be weaker than one neighbour, and must be stronger than the other. The cell's
/// responses along the beams and along the lines, and those of the neighbours before and after it in that direction.
EDGESCAN_INLINE bool isStrongest(float beamwise, float beamBefore, float beamAfter, float linewise, float lineBefore, float lineAfter) {
    const float b = std::abs(beamwise);
    const float l = std::abs(linewise);
    const bool keepB = (b >= l) & (std::abs(beamBefore) <= b) & (std::abs(beamAfter) < b);
    const bool keepL = (b < l) & (std::abs(lineBefore) <= l) & (std::abs(lineAfter) < l);
    return keepB | keepL;
}

/// The response of the stronger direction.
EDGESCAN_INLINE float strongerOf(float beamwise, float linewise) { return std::abs(beamwise) >= std::abs(linewise) ? beamwise : linewise; }

/// The fold of both directions: the root of the sum of squares where both have the same sign, because a diagonal fold shows only a part of
/// its angle in each direction.
EDGESCAN_INLINE float wholeFold(float beamwise, float linewise) {
    const bool isBeamwise = std::abs(beamwise) >= std::abs(linewise);
    const float stronger = isBeamwise ? beamwise : linewise;
    const float weaker = isBeamwise ? linewise : beamwise;
    const float add = stronger * weaker > 0 ? weaker * weaker : 0.0F;
    return std::copysign(std::sqrt(stronger * stronger + add), stronger);
}

} // namespace edgescan::edges
