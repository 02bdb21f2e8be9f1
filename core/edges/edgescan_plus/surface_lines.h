// Jumps and folds of a sweep line by line: every stage of EdgeScan+ processes a line as soon as the stage before has finished the lines
// that it needs.
#pragma once

#include "core/edges/edgescan_plus/crease.h"
#include "core/edges/edgescan_plus/range_field.h"
#include "core/scan/angle_correction/interlace.h"

#include <optional>
#include <vector>

namespace edgescan::edges {

/// The stages between a cleaned sweep and the decision (docs/method/edges.md, "Step 2" to "Step 5"), and the lines between them. The
/// results of a line depend only on a few dozen lines around it, and only these are stored.
class SurfaceLines {
public:
    /// The results of a line depend on at most this many lines before it.
    static constexpr int kLinesBefore = 34;

    /// Stores the references. Begins at line `from` as if it were the first line. `parts`: also those of the folds are stored.
    SurfaceLines(const InverseRange& inverse, const AngularSteps& steps, const SweepSlips& slips, const DepthLimits& limits, int from = 0,
                 bool parts = false);

    /// Reads one more line of the sweep; after the last one, lines of the margin.
    void advance();

    /// S_J per cell in both directions, ...
    [[nodiscard]] const Lines& jumps(Along along) const { return along == Along::Beams ? jumpBeams_ : jumpLines_; }
    /// ... and S_C. Both have lines of 0 behind the last line of the sweep.
    [[nodiscard]] const Lines& folds(Along along) const { return along == Along::Beams ? folds_.alongBeams : folds_.alongLines; }

    /// What the folds are made of, if that is stored.
    [[nodiscard]] const std::optional<FoldPartLines>& parts() const { return parts_; }

    /// S_J of the cracks of the newest line of jumps; empty before the first.
    [[nodiscard]] const Lines& cracks(Along along) const { return along == Along::Beams ? crackBeams_ : crackLines_; }

    /// u of the newest lines of jumps, with mixed pixels moved to a surface, and the solid flags.
    [[nodiscard]] DepthField surface() const { return {snapped_, solid_}; }
    /// Smoothed u of the newest line of folds and of those around it, and the links between neighbours.
    [[nodiscard]] const Lines& smoothed() const { return passes_.back().lines; }
    [[nodiscard]] const Links& links(Along along) const { return along == Along::Beams ? linkBeams_ : linkLines_; }

    /// The newest line; negative before the first.
    [[nodiscard]] int jumpLine() const { return crackLine_; }
    [[nodiscard]] int foldLine() const { return crackLine_ - limits_.passes - kFoldReach; }

private:
    [[nodiscard]] bool isInside(int line) const { return line >= from_ && line < lines_; }
    void addLine(int line);
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
    Lines snappedOnce_; // u, with mixed pixels moved along the beams ...
    Lines snapped_;     // ... and along the lines
    Lines crackBeams_, crackLines_;
    Links linkBeams_, linkLines_;
    Lines jumpBeams_, jumpLines_;
    struct Pass {
        Lines beams, lines; // u, smoothed in both directions
    };
    std::vector<Pass> passes_;
    FoldWork work_;
    FoldStrengths folds_;
    std::optional<FoldPartLines> parts_;
};

} // namespace edgescan::edges
