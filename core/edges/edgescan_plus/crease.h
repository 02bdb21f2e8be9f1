// Creases: the angle between two planes fitted to both sides of a cell (docs/method/edges.md, "Step 5"), line by line.
#pragma once

#include "core/edges/edgescan_plus/range_field.h"

#include <vector>

namespace edgescan::edges {

/// Number of lines before and after its own that foldStrengths() reads.
inline constexpr int kFoldReach = Lines::kMargin;

/// The effect of white noise of standard deviation 1 on the difference of the slopes of two sides, in units of 1 / sqrt(sum of squared
/// distances from the middle of a side): the factor for two slopes, times the share of the noise that remains after smoothing.
inline constexpr float kFoldOfWhite = 1.41F * 0.55F;

/// S_C per cell in both directions. Positive: convex; negative: concave. 1 = at the threshold.
struct FoldStrengths {
    Lines alongBeams;
    Lines alongLines;
    /// Adds a line in which nothing folds.
    void nextEmpty() {
        alongBeams.nextEmpty();
        alongLines.nextEmpty();
    }
};

/// What S_C of the cells in one direction is made of: size / (all * max(C0 * flatter, noise)), with C0 the crease angle.
struct FoldParts {
    const float* size; ///< with the sign of S_C; 0 where nothing folds at any crease angle
    const float* all;
    const float* flatter;
    const float* noise;
};
/// S_C at a crease angle, degrees.
void strengthsAt(const FoldParts& parts, int cells, float creaseDeg, float* strengths);

/// The parts of some lines, in both directions.
struct FoldPartLines {
    struct Way {
        Lines size, all, flatter, noise;
        [[nodiscard]] FoldParts at(int line) const { return {size.line(line), all.line(line), flatter.line(line), noise.line(line)}; }
        void nextEmpty() {
            for (Lines* lines : {&size, &all, &flatter, &noise}) lines->nextEmpty();
        }
    };
    Way alongBeams, alongLines;
    /// Adds a line in which nothing folds.
    void nextEmpty() {
        alongBeams.nextEmpty();
        alongLines.nextEmpty();
    }
};

/// Buffers for the work on a line, reused for every line.
struct FoldWork {
    std::vector<float> angles;
};

/// Computes the next line of `strengths`. Least-squares lines in u are fitted to the cell and up to k = clamp(round(window / (r a)), 3, 15)
/// cells on each side, ending at a break; at least two cells on both sides. S_C is the dihedral angle of the two planes divided by the
/// larger of C0 and 4.5 times the noise of the angle; its weight is smaller where the lines do not meet at the cell. The slope across the
/// direction tilts the planes, because a fold seen at a grazing angle is less sharp than it appears within one scan plane. `parts`: if it
/// is not null, gets the next line, too.
void foldStrengths(const Lines& u, const Links& linksAlongBeams, const Links& linksAlongLines, const AngularSteps& steps, int line,
                   const DepthLimits& limits, FoldWork& work, FoldStrengths& strengths, FoldPartLines* parts = nullptr);

} // namespace edgescan::edges
