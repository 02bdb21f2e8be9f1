// Creases: how far two planes fitted to both sides of a cell are folded against each other (METHOD.md step 5).
#pragma once

#include "core/edges/depth_field.h"

namespace edgescan {

/// S_C per cell, both ways. Positive: convex; negative: concave.
struct FoldStrengths {
    PaddedGrid<float> alongBeams;
    PaddedGrid<float> alongLines;
};

/// Least-squares lines in u through the cell and up to k = clamp(round(window / (r a)), 3, 16) cells on each side, ending at a break; two
/// cells at least on both. S_C: the dihedral angle of the two planes over the greater of C0 and five times its noise, less where the lines
/// do not meet at the cell. The slope across tilts the planes: a fold seen at a grazing angle is not as sharp as it looks within one scan
/// plane.
[[nodiscard]] FoldStrengths foldStrengths(const PaddedGrid<float>& u, const PaddedGrid<float>& linksAlongBeams,
                                          const PaddedGrid<float>& linksAlongLines, const AngularSteps& steps, const DepthLimits& limits);

} // namespace edgescan
