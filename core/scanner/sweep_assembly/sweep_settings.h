// The values of scanner and stepper that are needed to assemble lines into a sweep; stored in a recording's metadata record "sweep".
#pragma once

#include "core/scan/grid/scan.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace edgescan::scanner {

/// Which of a beam's returns gives the range.
enum class Echo : std::uint8_t { First, Last };

struct SweepSettings {
    Axis axis = Axis::Spin;
    double lineDirection = 1.0; ///< as PolarGeometry::lineDirection
    double firstLineDeg = 0.0;  ///< stepper angle at which counts, steps or time begin

    std::optional<double> ticksPerDeg;        ///< encoder counts per degree, negative if it counts backwards; empty: no encoder
    std::optional<std::uint32_t> encoderZero; ///< count at firstLineDeg; empty: count of the first line that arrives
    std::optional<double> degPerLine = 0.18;  ///< the stepper's step per line, signed; empty: line angles are computed from time
    double degPerSecond = 4.5;                ///< only if line angles are computed from time

    bool continuous = true; ///< the stepper moves while the mirror rotates: each beam has its own line angle
    /// Beam angle of the mirror at a line's time stamp, from the calibration (docs/developer/protocol.md, "Time of a beam").
    double indexDeg = -144.0;
    int expectedLines = 0;    ///< lines of a whole sweep; 0: unknown, only a reversal ends a sweep
    double reversalDeg = 0.5; ///< a larger move back starts a new sweep; 0: never
    int longestGap =
        2000; ///< if more consecutive lines are lost, a new sweep starts (or earlier, if lost lines would outnumber all others by far)
    int mostLines = 20000;  ///< largest number of lines of a sweep
    int outputInterval = 0; ///< number of scans per telegram; 0: learn it
    Echo echo = Echo::First;

    /// The value above was not given by the stream, the calibration or a flag: it is a guess, and the operator who opens the sweep is
    /// warned.
    bool axisAssumed = false, stepAssumed = false;
    bool firstAssumed = false; ///< likewise firstLineDeg; it only turns the whole cloud about the stepper's axis

    bool operator==(const SweepSettings&) const = default;
};

/// Degrees per line where no step was given: half a turn over all lines, where their number is known.
[[nodiscard]] inline double assumedStepDeg(int expectedLines) { return expectedLines > 0 ? 180.0 / expectedLines : 0.18; }

/// The angle of the first line where none was given: a sweep that nods over all lines is as far on both sides of the viewing direction.
[[nodiscard]] inline double assumedFirstDeg(Axis axis, const SweepSettings& settings) {
    return axis == Axis::Sweep && settings.expectedLines > 0 && settings.degPerLine ? -0.5 * settings.expectedLines * *settings.degPerLine
                                                                                    : 0.0;
}

/// True if an angle of the first line that was not given is a guess. A given spin begins at 0: another angle only turns the scan about the
/// vertical, while a sweep would look in another direction.
[[nodiscard]] inline bool guessesFirst(const SweepSettings& settings) { return settings.axisAssumed || settings.axis == Axis::Sweep; }

/// Settings without any given value.
[[nodiscard]] inline SweepSettings assumedSweep() {
    SweepSettings settings;
    settings.axisAssumed = settings.stepAssumed = settings.firstAssumed = true;
    return settings;
}

using SweepMetadata = std::map<std::string, std::string>;

/// The keys for these settings, besides "format": "sweep/1".
[[nodiscard]] SweepMetadata metadataOf(const SweepSettings& settings);

/// The settings in a metadata record. A value that the record does not give is taken from `otherwise`; if that is the axis or the step, it
/// is marked as assumed. `warnings` names values that cannot be used.
struct SettingsFound {
    SweepSettings settings;
    std::vector<std::string> warnings;
};
[[nodiscard]] SettingsFound settingsOf(const SweepMetadata& metadata, const SweepSettings& otherwise = {});

} // namespace edgescan::scanner
