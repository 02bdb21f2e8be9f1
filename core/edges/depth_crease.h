// Creases: how far two planes fitted to both sides of a cell are folded against each other (METHOD.md step 5).
#pragma once

#include "core/edges/depth_field.h"

namespace edgescan {

/// Planes left and right of a cell along one way. Tangents of the angle at which the surface recedes from the beam's cross plane,
/// per side; equal where only one side could be fitted, 0 where none.
struct SideFits {
    PaddedGrid<float> before;
    PaddedGrid<float> after;
    PaddedGrid<float> noise;  ///< standard deviation of the difference of the tangents, from the range noise
    PaddedGrid<float> misfit; ///< distance of the two lines at the cell along the beam, mm
    PaddedGrid<float> fitted; ///< 1 where both sides have two cells beyond the cell itself
};

/// Least-squares lines in u through the cell and up to k = clamp(round(window / (r a)), 3, 16) cells on each side, ending at a break.
[[nodiscard]] SideFits fitSides(const PaddedGrid<float>& u, const PaddedGrid<float>& links, const AngularSteps& steps, Along along,
                                const DepthLimits& limits);

/// S_C along one way: the dihedral angle of the two planes over the greater of C0 and five times its noise, less where the lines do not
/// meet at the cell. `across` tilts the planes: a fold seen at a grazing angle is not as sharp as it looks within one scan plane.
/// Positive: convex; negative: concave.
[[nodiscard]] PaddedGrid<float> foldStrength(const SideFits& along, const SideFits& across, const DepthLimits& limits);

} // namespace edgescan
