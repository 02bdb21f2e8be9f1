// Finds sweeps whose lines were measured with different beam phases in a repeating cycle (docs/method/edges.md, "Interlaced beams and
// slips").
#pragma once

#include "core/scan/grid/inverse_range.h"

#include <vector>

namespace edgescan {

struct LinePhases {
    /// beam steps by which line i is ahead: steps[i % steps.size()], 0 or more; empty: all lines have the same phase, or it cannot be
    /// measured
    std::vector<double> steps;
    double significance = 0; ///< the largest offset of a position from its neighbours, divided by its own standard deviation; 6 or more
};

/// Measures by how many beam steps the beams of line i are ahead of their recorded angles. The cells of each line on slanted surfaces are
/// compared with the lines before and after it. Nearly all lines must agree with the lines at the same position of the cycle. Cycles have
/// at most eight phases.
[[nodiscard]] LinePhases linePhases(const InverseRange& inverse);

/// Merges the lines of a cycle into one line: its beams are in the order of their angles, each with the angle of its original line as its
/// skew. Ranges and states are unchanged. Missing lines of an incomplete last cycle become lost cells. `phases` are those of linePhases();
/// all of them must be less than one beam step.
[[nodiscard]] Scan withPhasesFolded(const Scan& scan, const std::vector<double>& phases);

} // namespace edgescan
