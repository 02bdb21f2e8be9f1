// Gives lines the angle that the stepper reported, whichever of the two arrives first.
#pragma once

#include "core/scanner/sweep_assembly/line_angles.h"

#include <cstdint>
#include <deque>

namespace edgescan::scanner {

inline constexpr double kNsPerSecond = 1e9;
[[nodiscard]] inline double secondsBetween(std::int64_t fromNs, std::int64_t toNs) {
    return static_cast<double>(toNs - fromNs) / kNsPerSecond;
}

/// One report of the stepper (topic /stepper).
struct StepperReading {
    std::int64_t step = 0;
    double phiDeg = 0.0;
    double degPerSecond = 0.0;
    bool moving = false;
    std::int64_t hostNs = 0; ///< same clock as the lines

    bool operator==(const StepperReading&) const = default;
};

/// A reading with the arrival time of a line was latched with that line and is valid at the line's stamp. Other readings are valid at their
/// own time, and the angles of lines between two of them are interpolated.
class StepperTrack {
public:
    /// A line that just arrived: it gets the angle known so far.
    void line(LineTiming& line) const;
    /// A new reading: the last lines that it affects get their angle.
    void reading(const StepperReading& reading, std::span<LineTiming> lines);

private:
    std::deque<StepperReading> last_; // newest at the back
};

} // namespace edgescan::scanner
