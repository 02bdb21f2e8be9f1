// Lines that were measured with beams of different phases, one after the other in turn (docs/method.md, "Interlaced beams and slips").
#pragma once

#include "core/scan/grid/inverse_range.h"

#include <vector>

namespace edgescan {

struct LinePhases {
    std::vector<double>
        steps;         ///< of line i steps[i % steps.size()], at least 0; empty: all lines have the same phase, or it cannot be told
    double surest = 0; ///< the largest difference of a place from its neighbours, over its own standard deviation; 6 or more
};

/// By how many beam steps the beams of line i lie ahead of their angles. Of every line its cells on slanted surfaces are compared with the
/// lines before and after it; nearly all lines must agree with the others of their turn. Up to eight phases.
[[nodiscard]] LinePhases linePhases(const InverseRange& inverse);

/// The lines of a turn side by side as one line: beams in the order of their angles, each with the angle of its line as its skew. Ranges
/// and states stay; cells of a last turn that is not whole are lost ones. `phases` as linePhases(), their beams all between a beam and the
/// next.
[[nodiscard]] Scan withPhasesFolded(const Scan& scan, const std::vector<double>& phases);

} // namespace edgescan
