// Backlash of the stepper, from two passes over the same lines: there and back (docs/calibration.md, "Backlash").
#pragma once

#include "core/base/result.h"
#include "core/scan/grid/scan.h"

namespace edgescan {

struct Backlash {
    double deg = 0;           ///< true line angle of the pass back minus that of the pass there, where both say the same angle
    double sdDeg = 0;         ///< standard deviation; larger than the plain one by what trial asked for
    std::size_t cells = 0;    ///< that were compared
    double apartBeforeMm = 0; ///< median distance of the two passes along the beam
    double apartAfterMm = 0;  ///< and with the backlash taken off
};

/// Both need line angles, the same beams and overlapping lines; any mounting, in any order of lines. Nothing else of the assembly shows in
/// two passes. Error: they do not fit each other, or the surfaces tell too little.
Result<Backlash> backlashOf(const Scan& there, const Scan& back);

} // namespace edgescan
