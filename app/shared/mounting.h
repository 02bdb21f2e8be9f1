// The user's description of the stepper of a live scanner: flags, or the robot's calibration file.
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
    bool stopAndGo = false;
};

/// --expected-lines --ticks-per-degree --stop-and-go, in a group of the help.
void addMountingFlags(CLI::App& command, Mounting& mounting, const std::string& group);

/// Flags override the calibration, which gives the axis, the step and the mirror's index angle. Values missing in both are marked as
/// assumed. Error: the calibration cannot be read.
[[nodiscard]] Result<scanner::SweepSettings> sweepOf(const Mounting& mounting);

} // namespace edgescan::cli
