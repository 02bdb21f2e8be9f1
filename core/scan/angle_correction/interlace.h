// Finds lines and beams that were measured at other angles than recorded: beams interlaced from two passes, and lines at which the stepper
// slipped (docs/method/edges.md, "Interlaced beams and slips").
#pragma once

#include "core/scan/angle_correction/line_slips.h"

#include <array>
#include <cstdint>
#include <vector>

namespace edgescan {

/// Displacements of lines and beams, in index steps across the lines (1 = the angle between two lines). On every slanted surface of a line
/// a displacement has the same size: the distance of a cell from the straight line through its neighbours, divided by the slope of the
/// surface across the lines.
struct SweepSlips {
    std::vector<float> parity; ///< `lines` values: how far odd beams were measured ahead of even ones, index steps
    LineSteps
        remaining;      ///< what is left of each slip after straighten() moved the cells of stalled lines to their true angles, index steps
    LineSteps measured; ///< all slips as measured, index steps
    bool interlaced = false; ///< true if most lines show interlaced beams; otherwise parity is all 0
    int slipCount = 0;       ///< values of `measured` that are not 0
    std::vector<std::uint8_t>
        turned; ///< steps at which the stepper turned (core/scan/angle_correction/turned_steps.h); empty if it did not
};

/// The result for a sweep in which every line and beam is at its recorded angle.
[[nodiscard]] SweepSlips noSlips(int lines);

/// Measures the displacements as weighted medians over the slanted cells of each line, and corrects `inverse`. Odd and even interlaced
/// beams are each moved by half of the displacement to the angle of their line. Slipped lines are moved to their places. No value is
/// interpolated across a jump. Lines whose cells disagree are neither reported nor moved. The result is the same for any number of threads
/// (0: as many as make it faster).
[[nodiscard]] SweepSlips straighten(InverseRange& inverse, int threads = 0);

} // namespace edgescan
