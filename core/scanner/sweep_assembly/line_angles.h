// The stepper angle of each line of a sweep: from the encoder, else from the stepper, else counted in steps, else from time.
#pragma once

#include "core/scanner/sweep_assembly/sweep_settings.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace edgescan {

enum class AngleSource : std::uint8_t { Encoder, Stepper, Steps, Time };

/// What one line brought along about its angle.
struct LineFacts {
    bool received = false;
    int turns = 0;                       ///< mirror turns after the line's first part, when only a later part arrived
    std::int64_t hostNs = 0;             ///< when it arrived
    std::int64_t stampNs = 0;            ///< its time stamp by the host's clock
    double seconds = 0.0;                ///< device clock, running on through restarts
    double secondsPerTurn = 0.04;        ///< of the mirror
    std::optional<std::int64_t> encoder; ///< count from the zero on
    std::optional<double> stepperDeg;    ///< what the stepper said
    bool stepperSettled = false;         ///< and nothing that comes will change it
    double degPerSecond = 0.0;           ///< said by the stepper; 0 while it stands
};

struct LineAngles {
    AngleSource source = AngleSource::Steps;
    std::vector<double> lineDeg; ///< one per line; lost lines lie between their neighbours
    double degPerTurn = 0.0;     ///< of the stepper while the mirror turns once; 0 when it stands while measuring
};

/// The best source that any of the lines has.
[[nodiscard]] AngleSource angleSourceOf(std::span<const LineFacts> lines, const SweepSettings& settings);

/// The angle of one line where it is known for sure and came from the motor itself.
[[nodiscard]] std::optional<double> measuredDeg(const LineFacts& line, AngleSource source, const SweepSettings& settings);

[[nodiscard]] LineAngles lineAngles(std::span<const LineFacts> lines, const SweepSettings& settings);

/// Degrees to add to a line's angle per beam; beam j is measured `turnsOf[j % parts]` mirror turns after the line's stamp
/// (docs/protocol.md, "Time of a beam").
[[nodiscard]] std::vector<double> lineSkewDeg(std::span<const double> beamDeg, std::span<const int> turnsOf, double degPerTurn,
                                              double indexDeg);

} // namespace edgescan
