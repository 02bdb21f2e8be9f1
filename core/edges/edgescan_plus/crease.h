// Creases: how far two planes fitted to both sides of a cell are folded against each other (docs/method.md, "Step 5"), line by line.
#pragma once

#include "core/edges/edgescan_plus/range_field.h"

#include <vector>

namespace edgescan {

/// foldStrengths() looks at so many lines before and after its own.
inline constexpr int kFoldLooks = Lines::kMargin;

/// What white noise of standard deviation 1 makes of the difference of two sides, in units of 1 / sqrt(sum of squared distances from the
/// middle of a side): two slopes, and the share of the noise that is left after smoothing.
inline constexpr float kFoldOfWhite = 1.41F * 0.55F;

/// S_C per cell, both ways. Positive: convex; negative: concave.
struct FoldStrengths {
    Lines alongBeams;
    Lines alongLines;
};

/// Memory for the work on a line, used again for every line.
struct FoldWork {
    std::vector<float> angles;
};

/// The next line of `strengths`. Least-squares lines in u through the cell and up to k = clamp(round(window / (r a)), 3, 15) cells on each
/// side, ending at a break; two cells at least on both. S_C is the dihedral angle of the two planes over the greater of C0 and 4.5 times
/// its noise; it counts for less where the lines do not meet at the cell. The slope across tilts the planes, because a fold seen at a
/// grazing angle is not as sharp as it looks within one scan plane.
void foldStrengths(const Lines& u, const Links& linksAlongBeams, const Links& linksAlongLines, const AngularSteps& steps, int line,
                   const DepthLimits& limits, FoldWork& work, FoldStrengths& strengths);

} // namespace edgescan
