// Backlash of the stepper, from two passes over the same lines: forward and back (docs/reference/calibration.md, "Backlash").
#pragma once

#include "core/base/result.h"
#include "core/scan/grid/scan.h"

namespace edgescan::inspect {

struct Backlash {
    /// true line angle of the return pass minus that of the forward pass, where both recorded the same angle, degrees
    double deg = 0;
    double sdDeg = 0;         ///< standard deviation, degrees; larger than the formal one by an amount found in simulations
    std::size_t cells = 0;    ///< number of cells compared
    double apartBeforeMm = 0; ///< median distance of the two passes along the beam, mm
    double apartAfterMm = 0;  ///< the same after the backlash is corrected
};

/// Both scans need line angles, the same beams and overlapping lines; any mounting, lines in any order. Two passes show no other assembly
/// error. Error: the scans do not fit each other, or their surfaces do not determine the backlash.
Result<Backlash> backlashOf(const Scan& there, const Scan& back);

} // namespace edgescan::inspect
