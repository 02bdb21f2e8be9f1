// Where lines and beams of a sweep are not where their angles say: beams interlaced from two passes, and lines at which the stepper
// slipped (docs/method.md, "Interlaced beams and slips").
#pragma once

#include "core/straighten/line_slips.h"

#include <array>
#include <vector>

namespace edgescan {

/// In index steps across the lines. A displacement shows on every slanted surface alike: what a cell lies off the straight line of its
/// neighbours, over the slope of the surface across the lines, is one number for the whole line.
struct SweepSlips {
    std::vector<float> parity; ///< lines values: how far odd beams were measured ahead of even ones
    LineSteps extra;           ///< slips that are left after the cells were brought to their lines
    LineSteps measured;        ///< all slips
    bool interlaced = false;   ///< parity says so on most lines; else parity is all 0
    int slipCount = 0;         ///< values of `measured` that are not 0
};

/// Every line and beam where its angle says.
[[nodiscard]] SweepSlips noSlips(int lines);

/// Measures the displacements as robust medians over the slanted cells of each line, and brings interlaced beams to the angle of their
/// line, half of the displacement each; never across a jump. Nothing is reported, nor moved, where the cells do not agree.
[[nodiscard]] SweepSlips straighten(InverseRange& inverse);

} // namespace edgescan
