// Flags of several commands: how to read a file, the settings of the method, and progress.
#pragma once

#include "app/shared/exits.h"
#include "app/shared/numbers.h"
#include "app/shared/typed_settings.h"
#include "core/base/result.h"
#include "core/exports/provenance.h"
#include "core/files/live_feed/live_feed.h"
#include "core/files/open_save/open_scan.h"
#include "core/rocks/selection/preset.h"
#include "core/scan/grid/scan.h"
#include "core/scanner/sweep_assembly/sweep_settings.h"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>
#include <utility>
#include <vector>

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

/// Error: a step or counts of 0.
[[nodiscard]] Result<Done> checkMounting(const Mounting& mounting);

/// The flags without effect on the lines or clouds of a robot's bridge, a sentence each, once the first of them came.
[[nodiscard]] std::vector<std::string> idleMounting(const Mounting& mounting, const std::string& joint, const files::LiveStatus& status);

/// Flags override the calibration, which gives the axis, the step and the mirror's index angle. Values missing in both are marked as
/// assumed. Error: the calibration cannot be read.
[[nodiscard]] Result<scanner::SweepSettings> sweepOf(const Mounting& mounting);

/// One flag per row of the table of reading options, and --progress.
struct ReadFlags {
    ReadingOptions options;
    bool progress = false;
};
void addReadFlags(CLI::App& command, ReadFlags& flags);

/// Adds only --pose and --calibration; for commands that play recordings.
void addPlaceFlags(CLI::App& command, ReadingOptions& options);

/// Adds --poses-3dtk, for the commands that compare two scans.
void addPosesFlag(CLI::App& command, std::vector<std::string>& poses);

/// The reading options of the flags. Progress is printed on stderr if it is a terminal or with --progress.
[[nodiscard]] ReadingOptions readingOptions(const ReadFlags& flags);

/// Error: several scans, and one pose file for all of them.
[[nodiscard]] Result<Done> checkOnePose(const std::vector<std::string>& files, const ReadFlags& flags);

/// Opens the scan. Warnings about assumed, repaired or dropped data are printed on stderr.
[[nodiscard]] Result<Scan> openAndWarn(const std::string& file, const ReadFlags& flags);

/// Adds --frame --ascii --include-attached --operator --role and the options of formats.
void addWriteFlags(CLI::App& command, WriteFlags& flags);

/// Prints it on stderr if the scan has no points that --include-attached adds.
void warnOfIdleWriting(const WriteFlags& flags, const Scan& scan);

/// Adds --preset and one flag per row of the parameter table; the values go into `flags`.
void addMethodFlags(CLI::App& command, MethodFlags& flags);

/// As checkMethod(). What the flags choose without saying so is printed on stderr.
[[nodiscard]] Result<Done> checkMethodAndWarn(const MethodFlags& flags);

struct RockFlags {
    std::vector<std::pair<const rocks::RockParameter*, double>> typed;
    std::string region, edits; ///< as typed
    std::vector<rocks::RegionCorner> corners;
};

/// Adds one flag per row of rockParameters(), --region, and --edits for commands with one scan.
void addRockFlags(CLI::App& command, RockFlags& flags, bool ofOneScan);

/// True if any of these flags is given.
[[nodiscard]] bool anyTyped(const RockFlags& flags);

/// Parses the region; from here on a file of edits is an input. Error: the region is invalid.
Result<Done> checkRocks(RockFlags& flags);

/// "--level 1 --region '0,0 9,9'", for a POSIX shell.
[[nodiscard]] std::string typedFlags(const RockFlags& flags);

/// Reads the file of edits. Typed settings override those of the file. The settings of the result are always present.
Result<rocks::Preset> presetOf(const RockFlags& flags, const Scan& scan);

} // namespace edgescan::cli
