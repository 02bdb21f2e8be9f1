// Flags that several commands share: how a file is read, which settings the method gets, and how progress is told.
#pragma once

#include "core/base/result.h"
#include "core/io/open_as_asked.h"
#include "core/report/provenance.h"
#include "core/scan/scan.h"
#include "core/settings/presets.h"

#include <CLI/CLI.hpp>

#include <map>
#include <string>
#include <vector>

namespace edgescan::cli {

/// One flag per row of the table of reading options, and --progress.
struct ReadFlags {
    ReadingOptions options;
    bool progress = false;
};
void addReadFlags(CLI::App& command, ReadFlags& flags);

/// --pose and --calibration alone, for what plays recordings.
void addPlaceFlags(CLI::App& command, ReadingOptions& options);

/// The options to open with; progress goes to stderr, on a terminal or with --progress.
[[nodiscard]] ReadingOptions readingOptions(const ReadFlags& flags);

/// --frame --ascii --include-attached --operator --role: how clouds and records are written.
struct WriteFlags {
    std::string frame = "auto";
    bool ascii = false;
    bool includeAttached = false;
    std::string operatorName, role;
};
void addWriteFlags(CLI::App& command, WriteFlags& flags);

/// For this scan; `usual` is the frame of "auto".
[[nodiscard]] ExportOptions exportOptions(const WriteFlags& flags, CoordinateFrame usual);

/// --preset and one flag per row of the parameter table.
struct MethodFlags {
    std::string preset;                       ///< empty: default
    std::map<std::string, std::string> typed; ///< by parameter key
};
void addMethodFlags(CLI::App& command, MethodFlags& flags);

/// A preset or a parameter was given on the command line.
[[nodiscard]] bool anyTyped(const MethodFlags& flags);

/// The preset named; else the default, or Canny on gray levels where its flags were typed and no method was. Error: neither a built-in
/// preset nor a preset file.
[[nodiscard]] Result<Preset> presetOf(const MethodFlags& flags);

/// Preset first, then the flags; a method without a threshold typed keeps the step in depth at which the preset's starts an edge.
/// Error: a lower threshold typed as a depth, unknown preset, or values that do not go together.
[[nodiscard]] Result<Settings> settingsOf(const MethodFlags& flags);

/// Whether settingsFor() can work with these, before there is a scan.
[[nodiscard]] Result<Done> checkMethod(const MethodFlags& flags);

/// As settingsOf(), with a lower threshold that was typed as a depth ("0.5 m", "5 %") worked out for this scan.
[[nodiscard]] Result<Settings> settingsFor(const MethodFlags& flags, const Scan& scan);

/// "edgescan-cli: SENTENCE" on stderr.
void complain(const Error& error);

} // namespace edgescan::cli
