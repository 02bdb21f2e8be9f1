// One scan line, whatever scanner measured it: the only type that a scanner's driver gives to the assembly of sweeps.
#pragma once

#include "core/scan/grid/scan.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace edgescan::scanner {

/// The beams of a line. Interlaced modes alternate between two grids: compare the grids; do not use the first for all lines.
struct BeamGrid {
    double startDeg = 0.0;
    double stepDeg = 0.0;
    int beams = 0;

    bool operator==(const BeamGrid&) const = default;
};

/// A line's ranges, mm, one per beam. A range is valid where state is Valid; DeviceStatus cells hold their code times the unit.
struct LineRanges {
    std::vector<float> rangeMm;
    std::vector<CellState> state; ///< Valid, NoReturn or DeviceStatus
};

/// The scanner's warnings with a line.
struct DeviceFlags {
    bool error = false; ///< or not ready; set in the first telegrams after a start
    bool contaminationWarning = false;
    bool contaminationError = false;

    bool operator==(const DeviceFlags&) const = default;
};

/// The counters and clocks of the device at a line. All wrap.
struct LineCount {
    std::uint16_t telegrams = 0;     ///< lines that were sent
    std::uint16_t scans = 0;         ///< lines that were measured; may start again with a new measurement
    std::uint32_t sinceStartUs = 0;  ///< device clock at the line's stamp
    std::uint32_t transmittedUs = 0; ///< device clock when the line was sent
    double periodS = 0.04;           ///< from one line to the next that the scanner measures
};

/// The data of one line about its time and its angle.
struct LineTiming {
    bool received = false;
    int turns = 0;                       ///< mirror rotations after the line's first part, if only a later part arrived
    std::int64_t hostNs = 0;             ///< when it arrived
    std::int64_t stampNs = 0;            ///< its time stamp by the host's clock
    double seconds = 0.0;                ///< device clock, continuous over restarts
    double secondsPerTurn = 0.04;        ///< of the mirror; negative: it turns from large beam angles to small ones
    std::optional<std::int64_t> encoder; ///< count since the zero position
    std::optional<double> stepperDeg;    ///< as the stepper reported
    bool stepperSettled = false;         ///< true: later readings cannot change it
    double degPerSecond = 0.0;           ///< as the stepper reported; 0 if it is not moving
};

struct SweepLine {
    LineCount count;
    BeamGrid beams;
    LineRanges ranges;
    /// strength of each beam's echo, as the scanner counts it, NaN where it has none; empty: the line has none
    std::vector<float> intensity;
    double unitMm = 1.0;
    LineTiming facts; ///< the driver sets secondsPerTurn
    DeviceFlags device;
    std::uint32_t serialNumber = 0;               ///< 0: unknown
    std::string echoes;                           ///< range channels: "DIST1 DIST2", or "DIST1 (DIST2)" if the beams of the second differ
    std::optional<std::uint32_t> encoderPosition; ///< counts modulo 2^32; use differences
    bool otherLayer = false;                      ///< the fan is at an angle to the one that the stepper rotates
};

/// The angle without the scanner's rounding to 1/10000 degree: moved to the 1/24-degree grid if it rounds to it.
[[nodiscard]] double snappedDeg(double degrees);

} // namespace edgescan::scanner
