// The stepper angle of each line of a sweep: from the encoder, else from the stepper, else counted in steps, else from time.
#pragma once

#include "core/scanner/scan_line/scan_line.h"
#include "core/scanner/sweep_assembly/sweep_settings.h"

#include <cstdint>
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

} // namespace edgescan::scanner
