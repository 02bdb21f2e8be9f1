// What somebody types, on the command line or in Python: a preset and texts by parameter key, and how results are written.
#pragma once

#include "core/base/result.h"
#include "core/edges/settings/presets.h"
#include "core/exports/provenance/provenance.h"
#include "core/scan/grid/scan.h"

#include <map>
#include <string>

namespace edgescan::cli {

inline const std::string kNotTyped = "\n"; ///< no flag can hold it

/// --preset and one text per row of the parameter table.
struct MethodFlags {
    std::string preset;                       ///< empty: default
    std::map<std::string, std::string> typed; ///< by parameter key
};

/// Every parameter with kNotTyped.
[[nodiscard]] MethodFlags nothingTyped();

/// A preset or a parameter was given on the command line.
[[nodiscard]] bool anyTyped(const MethodFlags& flags);

/// The preset named; else the default, or Canny on gray levels where its flags were typed and no method was. Error: neither a built-in
/// preset nor a preset file.
[[nodiscard]] Result<Preset> presetOf(const MethodFlags& flags);

/// "--preset thesis --kernel 5": what was typed, in the order of the table; quoted for a POSIX shell.
[[nodiscard]] std::string typedFlags(const MethodFlags& flags);

/// Preset first, then the flags; a method without a threshold typed keeps the step in depth at which the preset's starts an edge.
/// Error: a lower threshold typed as a depth, unknown preset, or values that do not go together.
[[nodiscard]] Result<Settings> settingsOf(const MethodFlags& flags);

/// Whether settingsFor() can work with these, before there is a scan. A preset file is an input from here on (core/base/inputs.h).
[[nodiscard]] Result<Done> checkMethod(const MethodFlags& flags);

/// As settingsOf(), with a lower threshold that was typed as a depth ("0.5 m", "5 %") worked out for this scan.
[[nodiscard]] Result<Settings> settingsFor(const MethodFlags& flags, const Scan& scan);

/// --frame --ascii --include-attached --operator --role: how clouds and records are written.
struct WriteFlags {
    std::string frame = "auto";
    bool ascii = false;
    bool includeAttached = false;
    std::string operatorName, role;
    WritingChoices choices;
};

/// For this scan; `usual` is the frame of "auto".
[[nodiscard]] ExportOptions exportOptions(const WriteFlags& flags, CoordinateFrame usual);

} // namespace edgescan::cli
