// Lines and beams that are not where their angles say: beams interlaced from two passes, and lines at which the stepper
// slipped (docs/method.md, "Interlaced beams and slips").
#pragma once

#include "core/scan/angle_correction/line_slips.h"

#include <array>
#include <vector>

namespace edgescan {

/// All in index steps across the lines. A displacement is the same number on every slanted surface of a line: the distance of a cell from
/// the straight line of its neighbours, over the slope of the surface across the lines.
struct SweepSlips {
    std::vector<float> parity; ///< lines values: how far odd beams were measured ahead of even ones
    LineSteps extra;           ///< slips that remain after the cells were brought to their lines
    LineSteps measured;        ///< all slips
    bool interlaced = false;   ///< most lines show it; else parity is all 0
    int slipCount = 0;         ///< values of `measured` that are not 0
};

/// Every line and beam is where its angle says.
[[nodiscard]] SweepSlips noSlips(int lines);

/// Measures the displacements as weighted medians over the slanted cells of each line. Brings interlaced beams to the angle of their line,
/// odd and even ones by half of the displacement each, and slipped lines to their places; never across a jump. Where the cells of a line do
/// not agree, nothing is reported or moved. The same with any number of threads (0: as many as pay).
[[nodiscard]] SweepSlips straighten(InverseRange& inverse, int threads = 0);

} // namespace edgescan
