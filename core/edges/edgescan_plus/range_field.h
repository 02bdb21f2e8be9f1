// Inverse range line by line, as the stages of EdgeScan+ pass it on.
#pragma once

#include "core/scan/grid/inverse_range.h"
#include "core/scan/grid/line_window.h"

#include <algorithm>
#include <vector>

namespace edgescan {

/// The two ways through a sweep: along the fan, and across the lines.
enum class Along : std::uint8_t { Beams, Lines };

using Lines = LineWindow<float>;
using Links = LineWindow<std::uint8_t>; ///< 1 where a cell and the next one belong to one surface

[[nodiscard]] inline std::ptrdiff_t stepOf(const Lines& lines, Along along) { return along == Along::Beams ? 1 : lines.stride; }

struct DepthField {
    const Lines& u;     ///< 1/m; 1 in the margin
    const Lines& solid; ///< 1 where u was measured or filled, 0 in voids and in the margin

    [[nodiscard]] std::ptrdiff_t step(Along along) const { return stepOf(u, along); }
};

/// Thresholds of the stages, from sliders and noise (docs/method.md, "Step 3", "Step 5", "Step 6").
struct DepthLimits {
    float jumpMm = 30;    ///< J0
    float growth = 0.01F; ///< p
    float grazing = 0.1F; ///< g, index steps
    float misfitMm = 5;
    float windowMm = 60;
    float creaseDeg = 30; ///< C0
    float reliefMm = 5;   ///< roughness of a surface, measured across it; along a slanted beam it is longer
    bool noisy = false;   ///< lines at jumps run through three cells instead of two
    int passes = 1;       ///< of smoothing
    RangeNoise noise;
    RangeNoise foldNoise; ///< the white noise that folds surfaces as much as the scan's does within the window

    [[nodiscard]] float jumpAt(float rangeMm) const { return jumpMm + growth * rangeMm; }
};

/// Angle of one index step at the cells of a line, radians. `room` holds the values where they differ from line to line.
[[nodiscard]] inline const float* anglesOf(const AngularSteps& steps, Along along, int line, std::vector<float>& room) {
    if (along == Along::Beams) return steps.beam.data();
    const float step = steps.line[static_cast<std::size_t>(line)];
    room.resize(steps.fromAxis.size());
    std::transform(steps.fromAxis.begin(), steps.fromAxis.end(), room.begin(), [step](float sine) { return step * sine; });
    return room.data();
}

} // namespace edgescan
