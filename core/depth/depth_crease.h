// Creases: how far two planes fitted to both sides of a cell are folded against each other (docs/method.md, "Step 5"), line by line.
#pragma once

#include "core/depth/depth_field.h"

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
    explicit FoldWork(int beams);

    /// Sums over one side of each cell, of differences to the cell: these keep more digits than sums of u.
    struct SideSums {
        explicit SideSums(int beams);
        std::vector<float> cells, sum, weighted;
    };
    /// The lines fitted to both sides of each cell.
    struct LineFits {
        explicit LineFits(int beams);
        std::vector<float> before, after; ///< tangents of the slope away from the scanner; equal where only one side was fitted
        std::vector<float> noise;         ///< standard deviation of the difference of the tangents
        std::vector<float> misfit;        ///< distance of the two lines at the cell along the beam, mm
        std::vector<float> fitted;        ///< 1 where both sides have enough cells
    };
    std::vector<float> angles;
    std::vector<float> reach; ///< cells of a side that are within the window
    SideSums left, right;
    LineFits beamwise, linewise;
};

/// The next line of `strengths`. Least-squares lines in u through the cell and up to k = clamp(round(window / (r a)), 3, 15) cells on each
/// side, ending at a break; two cells at least on both. S_C is the dihedral angle of the two planes over the greater of C0 and 4.5 times
/// its noise; it counts for less where the lines do not meet at the cell. The slope across tilts the planes, because a fold seen at a
/// grazing angle is not as sharp as it looks within one scan plane.
void foldStrengths(const Lines& u, const Lines& linksAlongBeams, const Lines& linksAlongLines, const AngularSteps& steps, int line,
                   const DepthLimits& limits, FoldWork& work, FoldStrengths& strengths);

} // namespace edgescan
