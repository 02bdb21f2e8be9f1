// What has to be known about scanner and stepper to make a sweep out of lines; kept in a recording's metadata record "sweep".
#pragma once

#include "core/scan/grid/scan.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace edgescan {

/// Which of several returns of a beam gives the range.
enum class Echo : std::uint8_t { First, Last };

struct SweepSettings {
    Axis axis = Axis::Spin;
    double lineDirection = 1.0; ///< as PolarGeometry::lineDirection
    double firstLineDeg = 0.0;  ///< stepper angle where the counts, the steps or the time begin

    std::optional<double> ticksPerDeg;        ///< encoder counts per degree, negative when it counts backwards; empty: no encoder
    std::optional<std::uint32_t> encoderZero; ///< count at firstLineDeg; empty: that of the first line that arrives
    std::optional<double> degPerLine = 0.18;  ///< the stepper's step per line, signed; empty: lines are placed by time
    double degPerSecond = 4.5;                ///< only when placed by time

    bool continuous = true; ///< the stepper moves while the mirror turns: each beam gets a line angle of its own
    /// Beam angle at which the mirror stands at a line's time stamp: calibration (docs/protocol.md, "Time of a beam").
    double indexDeg = -144.0;
    int expectedLines = 0;    ///< lines of a whole sweep; 0: not known, a sweep ends with a reversal only
    double reversalDeg = 0.5; ///< a move back by more starts a new sweep; 0: never
    int longestGap = 2000;    ///< more lost lines in one go start a new sweep
    int mostLines = 20000;    ///< no sweep grows beyond
    int outputInterval = 0;   ///< every how many scans a telegram is sent; 0: found out
    Echo echo = Echo::First;

    /// Nobody said it, neither stream nor calibration nor flag: the value above is a guess, which whoever opens the sweep is told.
    bool axisAssumed = false, stepAssumed = false;

    bool operator==(const SweepSettings&) const = default;
};

/// Settings of which nothing was said.
[[nodiscard]] inline SweepSettings assumedSweep() {
    SweepSettings settings;
    settings.axisAssumed = settings.stepAssumed = true;
    return settings;
}

using SweepMetadata = std::map<std::string, std::string>;

/// The keys that the settings stand for, besides "format": "sweep/1".
[[nodiscard]] SweepMetadata metadataOf(const SweepSettings& settings);

/// Settings a metadata record stands for; what it does not say stays as in `otherwise`, and where that is the axis or the step, it is
/// assumed. `warnings` names values that cannot be used.
struct SettingsFound {
    SweepSettings settings;
    std::vector<std::string> warnings;
};
[[nodiscard]] SettingsFound settingsOf(const SweepMetadata& metadata, const SweepSettings& otherwise = {});

} // namespace edgescan
