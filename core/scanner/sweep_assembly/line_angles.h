// The stepper angle of each line of a sweep: from the encoder, else from the stepper, else counted in steps, else from time.
#pragma once

#include "core/scanner/scan_line/scan_line.h"
#include "core/scanner/sweep_assembly/sweep_settings.h"

#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <vector>

namespace edgescan::scanner {

enum class AngleSource : std::uint8_t { Encoder, Stepper, Steps, Time };

struct LineAngles {
    AngleSource source = AngleSource::Steps;
    std::vector<double> lineDeg; ///< one per line; lost lines are interpolated between their neighbours
    double degPerTurn = 0.0;     ///< rotation of the stepper during one rotation of the mirror; 0 if it does not move while measuring
};

/// The best source that any of the lines has.
[[nodiscard]] AngleSource angleSourceOf(std::span<const LineTiming> lines, const SweepSettings& settings);

/// The angle of one line if it is certain and was measured at the motor.
[[nodiscard]] std::optional<double> measuredDeg(const LineTiming& line, AngleSource source, const SweepSettings& settings);

[[nodiscard]] LineAngles lineAngles(std::span<const LineTiming> lines, const SweepSettings& settings);

/// Degrees to add to a line's angle per beam. Beam j is measured `turnsOf[j % parts]` mirror rotations after the line's stamp
/// (docs/developer/protocol.md, "Time of a beam").
[[nodiscard]] std::vector<double> lineSkewDeg(std::span<const double> beamDeg, std::span<const int> turnsOf, double degPerTurn,
                                              double indexDeg);

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
