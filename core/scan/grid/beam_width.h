// The width of the scanner's beam. Objects smaller than the beam and the distance to the next beam are not detected reliably.
#pragma once

namespace edgescan {

/// Width in metres at the exit, and growth in radians, of an LMS511 in high resolution; in its standard mode the beam grows by 0.011
/// (docs/reference/rules.md, "S15").
struct BeamWidth {
    double atExitM = 0.013;
    double growthRad = 0.0046;

    [[nodiscard]] constexpr double at(double rangeM) const { return atExitM + growthRad * rangeM; }
};

} // namespace edgescan
