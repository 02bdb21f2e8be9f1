// Inverse range line by line, as the stages of EdgeScan+ pass it on.
#pragma once

#include "core/scan/grid/inverse_range.h"
#include "core/scan/grid/line_window.h"

#include <algorithm>
#include <vector>

namespace edgescan::edges {

/// The two directions in a sweep: along the fan (from beam to beam), and across the lines (from line to line).
enum class Along : std::uint8_t { Beams, Lines };

using Lines = LineWindow<float>;
using Links = LineWindow<std::uint8_t>; ///< 1 where a cell and the next one belong to one surface

[[nodiscard]] inline std::ptrdiff_t stepOf(const Lines& lines, Along along) { return along == Along::Beams ? 1 : lines.stride; }

struct DepthField {
    const Lines& u;     ///< 1/m; 1 in the margin
    const Lines& solid; ///< 1 where u was measured or filled, 0 in voids and in the margin

    [[nodiscard]] std::ptrdiff_t step(Along along) const { return stepOf(u, along); }
};

/// Thresholds of the stages, from settings and noise (docs/method/edges.md, "Step 3", "Step 5", "Step 6"). depthLimits() sets all of them;
/// the values here are only placeholders. q is the noise divided by that of an LMS511, less what smoothNoise() removes.
struct DepthLimits {
    float jumpMm = 30;    ///< J0: smallest jump near the scanner, mm; automatic: 30 q
    float growth = 0.01F; ///< p: added to J0, as a share of the range
    float grazing = 0.1F; ///< g: displacement, in index steps, that is tolerated on a grazing surface
    /// misfit: distance of the two lines of a fold at the cell, mm, at which the fold has lost part of its weight; depthLimits(): 6 q
    float misfitMm = 5;
    float windowMm = 60;  ///< w: length of one side of a fold, mm; depthLimits(): 50 q^0.7
    float creaseDeg = 30; ///< C0: smallest fold, degrees
    float reliefMm = 5;   ///< roughness of a surface, mm, measured across it; along a slanted beam it is longer; depthLimits(): 5 q
    float noisy = 0;      ///< share of a second smoothing pass, and of straight lines of three cells instead of two at jumps
    int passes = 1;       ///< number of smoothing passes: 2 if `noisy` is above 0
    /// The spot of the beam covers several cells of a dense grid: runs of more than two mixed pixels, and folds that leave out half of it.
    bool spotGrows = false;
    float rimSlant = 0; ///< tangent of the largest slant of a surface that has a rim at a void
    bool turns = true;  ///< lines are not linked at steps at which the stepper turned
    RangeNoise noise;
    RangeNoise foldNoise; ///< the white noise that causes as large folds within the window as the scan's noise does

    /// Jump threshold at a range; both in mm.
    [[nodiscard]] float jumpAt(float rangeMm) const { return jumpMm + growth * rangeMm; }
};

/// Angle of one index step at the cells of a line, radians. `buffer` holds the values if they differ from line to line.
[[nodiscard]] inline const float* anglesOf(const AngularSteps& steps, Along along, int line, std::vector<float>& buffer) {
    if (along == Along::Beams) return steps.beam.data();
    const float step = steps.line[static_cast<std::size_t>(line)];
    buffer.resize(steps.fromAxis.size());
    std::transform(steps.fromAxis.begin(), steps.fromAxis.end(), buffer.begin(), [step](float sine) { return step * sine; });
    return buffer.data();
}

} // namespace edgescan::edges
