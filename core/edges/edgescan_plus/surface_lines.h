// Jumps and folds of a sweep line by line: every stage of EdgeScan+ works on a line as soon as the stage before has done what it looks at.
#pragma once

#include "core/edges/edgescan_plus/crease.h"
#include "core/edges/edgescan_plus/range_field.h"
#include "core/scan/angle_correction/interlace.h"

#include <vector>

namespace edgescan {

/// The stages between a cleaned sweep and what is decided on (docs/method.md, "Step 2" to "Step 5"), and the lines between them. What they
/// say of a line depends on no more than a few dozen lines round it, and no more are held.
class SurfaceLines {
public:
    /// What is said of a line depends on no more than so many lines before it.
    static constexpr int kLooksBack = 32;

    /// The references are kept. Begins at line `from`, as if no lines were before it.
    SurfaceLines(const InverseRange& inverse, const AngularSteps& steps, const SweepSlips& slips, const DepthLimits& limits, int from = 0);

    /// Takes up one more line of the sweep; after the last one, lines of the margin.
    void advance();

    /// S_J per cell, both ways, ...
    [[nodiscard]] const Lines& jumps(Along along) const { return along == Along::Beams ? jumpBeams_ : jumpLines_; }
    /// ... and S_C. Both have lines of 0 after the last one of the sweep.
    [[nodiscard]] const Lines& folds(Along along) const { return along == Along::Beams ? folds_.alongBeams : folds_.alongLines; }

    /// S_J of the cracks of the newest line of jumps; empty before the first.
    [[nodiscard]] const Lines& cracks(Along along) const { return along == Along::Beams ? crackBeams_ : crackLines_; }

    /// u of the newest lines of jumps, mixed pixels snapped, and where it is solid.
    [[nodiscard]] DepthField surface() const { return {snapped_, solid_}; }
    /// u of the newest line of folds and those around it, smoothed, and where neighbours are linked.
    [[nodiscard]] const Lines& smoothed() const { return passes_.back().lines; }
    [[nodiscard]] const Links& links(Along along) const { return along == Along::Beams ? linkBeams_ : linkLines_; }

    /// The newest line there is; negative before the first.
    [[nodiscard]] int jumpLine() const { return crackLine_; }
    [[nodiscard]] int foldLine() const { return crackLine_ - limits_.passes - kFoldLooks; }

private:
    [[nodiscard]] bool isInside(int line) const { return line >= from_ && line < lines_; }
    void takeLine(int line);
    void snapAlongBeams(int line);
    void snapAlongLines(int line);
    void findCracks(int line);
    void smooth(std::size_t pass, int line);
    void fitFolds(int line);

    const InverseRange& inverse_;
    const AngularSteps& steps_;
    const SweepSlips& slips_;
    const DepthLimits& limits_;
    int from_;
    int lines_;
    int crackLine_;  // newest line of cracks
    Lines measured_; // u
    Lines solid_;
    Lines snappedOnce_; // u, mixed pixels snapped along the beams ...
    Lines snapped_;     // ... and along the lines
    Lines crackBeams_, crackLines_;
    Links linkBeams_, linkLines_;
    Lines jumpBeams_, jumpLines_;
    struct Pass {
        Lines beams, lines; // u, smoothed along both
    };
    std::vector<Pass> passes_;
    FoldWork work_;
    FoldStrengths folds_;
};

} // namespace edgescan
