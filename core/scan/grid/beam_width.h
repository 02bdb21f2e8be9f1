// How wide the beam of the scanner is: what is smaller than it and the way to the next beam is not seen reliably.
#pragma once

namespace edgescan {

/// Of an LMS511 in high resolution; in its standard mode the beam grows by 0.011 (docs/operator.md, "S15").
struct BeamWidth {
    double atExitM = 0.013;
    double growthRad = 0.0046;

    [[nodiscard]] constexpr double at(double rangeM) const { return atExitM + growthRad * rangeM; }
};

} // namespace edgescan
