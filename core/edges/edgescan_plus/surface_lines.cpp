// The order of the stages, and by how many lines each is behind the one before.
#include "core/edges/edgescan_plus/surface_lines.h"

#include "core/base/simd.h"
#include "core/edges/edgescan_plus/jump.h"
#include "core/edges/edgescan_plus/mixed_pixels.h"

#include <algorithm>

namespace edgescan::edges {
namespace {

constexpr float kMarginU = 1.0F;
constexpr int kAround = 8; // lines of jumps and folds that can be read together
// By how many lines each stage is behind the line that is read.
constexpr int kToSnapped = kMixedLinesAfter;
constexpr int kToCracks = kToSnapped + kJumpLinesAfter;
constexpr int kSurfaceLines = kToCracks + kJumpLinesBefore + 1;
constexpr int kFoldLines = 2 * kFoldReach + 1;

constexpr int kMostPasses = 2;
static_assert(SurfaceLines::kLinesBefore >= 1 + kFoldReach + kMostPasses + kJumpLinesBefore + kMixedLinesWritten + kMixedLinesBefore + 1);
static_assert(kMixedLinesWritten <= kMixedLinesAfter && kMixedLinesBefore <= kJumpLinesAfter + kJumpLinesBefore);

EDGESCAN_INLINE void setSolid(const Support* support, int beams, float* __restrict solid) {
    for (int j = 0; j < beams; ++j) solid[j] = support[j] == Support::Void ? 0.0F : 1.0F;
}

} // namespace

SurfaceLines::SurfaceLines(const InverseRange& inverse, const AngularSteps& steps, const SweepSlips& slips, const DepthLimits& limits,
                           int from, bool parts)
    : inverse_(inverse), steps_(steps), slips_(slips), limits_(limits), from_(from), lines_(inverse.u.lines),
      crackLine_(from - 1 - kToCracks), measured_(inverse.u.beams, 1, kMarginU, from), solid_(inverse.u.beams, kSurfaceLines, 0.0F, from),
      snappedOnce_(inverse.u.beams, kSurfaceLines, kMarginU, from), snapped_(inverse.u.beams, kSurfaceLines, kMarginU, from),
      crackBeams_(inverse.u.beams, 1, 0.0F, from - 1), crackLines_(inverse.u.beams, 2, 0.0F, from - 1),
      linkBeams_(inverse.u.beams, kFoldReach + limits.passes + 1, 0, from - 1),
      linkLines_(inverse.u.beams, kFoldLines + limits.passes, 0, from - 1), jumpBeams_(inverse.u.beams, kAround, 0.0F, from),
      jumpLines_(inverse.u.beams, kAround, 0.0F, from), folds_{Lines(inverse.u.beams, kAround, 0.0F, from),
                                                               Lines(inverse.u.beams, kAround, 0.0F, from)} {
    for (int pass = 0; pass < limits.passes; ++pass)
        passes_.push_back({Lines(inverse.u.beams, 3, kMarginU, from), Lines(inverse.u.beams, kFoldLines, kMarginU, from)});
    const Lines none(inverse.u.beams, kAround, 0.0F, from), one(inverse.u.beams, kAround, 1.0F, from);
    if (parts) parts_ = {{none, one, one, one}, {none, one, one, one}};
}

void SurfaceLines::advance() {
    const int line = crackLine_ + kToCracks + 1;
    addLine(line);
    snapAlongBeams(line);
    snapAlongLines(line - kToSnapped);
    if (++crackLine_ < from_ - 1) return;
    findCracks(crackLine_);
    for (std::size_t pass = 0; pass < passes_.size(); ++pass) smooth(pass, crackLine_ - static_cast<int>(pass));
    fitFolds(foldLine());
}

void SurfaceLines::addLine(int line) {
    if (!isInside(line)) {
        measured_.nextEmpty();
        solid_.nextEmpty();
        return;
    }
    const float* u = inverse_.u.line(line);
    std::copy(u, u + inverse_.u.beams, measured_.next());
    vectorised<setSolid>(inverse_.support.line(line), inverse_.u.beams, solid_.next());
}

void SurfaceLines::snapAlongBeams(int line) {
    const float* u = measured_.line(line);
    std::copy(u, u + measured_.beams, snappedOnce_.next());
    if (isInside(line)) snapMixedPixels({measured_, solid_}, Along::Beams, line, steps_.beam.data(), limits_, snappedOnce_);
    u = snappedOnce_.line(line);
    std::copy(u, u + snappedOnce_.beams, snapped_.next());
}

void SurfaceLines::snapAlongLines(int line) {
    if (isInside(line))
        snapMixedPixels({snappedOnce_, solid_}, Along::Lines, line, anglesOf(steps_, Along::Lines, line, work_.angles), limits_, snapped_);
}

// Cracks from the margin before the first line to those of the last line.
void SurfaceLines::findCracks(int line) {
    const DepthField field{snapped_, solid_};
    if (!isInside(line)) {
        for (Lines* lines : {&crackBeams_, &crackLines_}) lines->nextEmpty();
        for (Links* links : {&linkBeams_, &linkLines_}) links->nextEmpty();
    } else {
        crackJumps(field, Along::Beams, line, anglesOf(steps_, Along::Beams, line, work_.angles), slips_, limits_, crackBeams_);
        crackJumps(field, Along::Lines, line, anglesOf(steps_, Along::Lines, line, work_.angles), slips_, limits_, crackLines_);
        surfaceLinks(field, crackBeams_, Along::Beams, line, slips_, linkBeams_);
        surfaceLinks(field, crackLines_, Along::Lines, line, slips_, linkLines_);
        const bool turned = limits_.turns && !slips_.turned.empty() && slips_.turned[static_cast<std::size_t>(line)] != 0;
        if (turned) std::fill_n(linkLines_.line(line) - 1, linkLines_.beams + 2, std::uint8_t{0});
    }
    if (isInside(line)) {
        jumpsOnNearerCells(field, crackBeams_, Along::Beams, line, jumpBeams_);
        jumpsOnNearerCells(field, crackLines_, Along::Lines, line, jumpLines_);
    } else if (line >= lines_) {
        jumpBeams_.nextEmpty();
        jumpLines_.nextEmpty();
    }
}

// Along the beams, and one line behind along the lines.
void SurfaceLines::smooth(std::size_t pass, int line) {
    const Lines& from = pass == 0 ? snapped_ : passes_[pass - 1].lines;
    Pass& to = passes_[pass];
    const float share = pass == 0 ? 1.0F : limits_.noisy;
    if (isInside(line))
        smoothSurfaces(from, linkBeams_, Along::Beams, line, share, to.beams);
    else if (line >= lines_)
        to.beams.nextEmpty();
    if (isInside(line - 1))
        smoothSurfaces(to.beams, linkLines_, Along::Lines, line - 1, share, to.lines);
    else if (line - 1 >= lines_)
        to.lines.nextEmpty();
}

void SurfaceLines::fitFolds(int line) {
    if (isInside(line)) {
        foldStrengths(passes_.back().lines, linkBeams_, linkLines_, steps_, line, limits_, work_, folds_, parts_ ? &*parts_ : nullptr);
    } else if (line >= lines_) {
        folds_.nextEmpty();
        if (parts_) parts_->nextEmpty();
    }
}

} // namespace edgescan::edges
