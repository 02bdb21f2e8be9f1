// What the user says of the stepper for a live scanner: by flags, or by the robot's calibration.
#pragma once

#include "core/base/result.h"
#include "core/scanner/sweep_assembly/sweep_settings.h"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>

namespace edgescan::cli {

struct Mounting {
    std::optional<Axis> axis;
    std::optional<double> lineStepDeg, firstLineDeg, ticksPerDeg;
    std::string calibration; ///< path
    int expectedLines = 0;
    bool standing = false;
};

/// --expected-lines --ticks-per-degree --standing, in a group of the help.
void addMountingFlags(CLI::App& command, Mounting& mounting, const std::string& group);

/// Flags go before the calibration, which says the axis, the step and where the mirror stands; what neither says is marked as assumed.
/// Error: the calibration cannot be read.
[[nodiscard]] Result<SweepSettings> sweepOf(const Mounting& mounting);

} // namespace edgescan::cli
