// Settings typed by the user on the command line or in Python: a preset, a text per parameter key, and how results are written.
#pragma once

#include "core/base/result.h"
#include "core/edges/settings/presets.h"
#include "core/exports/export_kinds.h"
#include "core/exports/provenance.h"
#include "core/scan/grid/scan.h"

#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace edgescan::cli {

inline const std::string kNotTyped = "\n"; ///< a flag cannot contain it

/// --preset and one text per row of the parameter table.
struct MethodFlags {
    std::string preset;                       ///< empty: default
    std::map<std::string, std::string> typed; ///< by parameter key
};

/// Every parameter is set to kNotTyped.
[[nodiscard]] MethodFlags noFlags();

/// True if the command line gives a preset or a parameter.
[[nodiscard]] bool anyTyped(const MethodFlags& flags);

/// The named preset. Without a name: the default preset, or Canny on gray levels if its flags are typed and no method is. Error: the name
/// is neither a built-in preset nor a preset file.
[[nodiscard]] Result<edges::Preset> presetOf(const MethodFlags& flags);

/// "--preset thesis --kernel 5": the typed flags in the order of the table, quoted for a POSIX shell.
[[nodiscard]] std::string typedFlags(const MethodFlags& flags);

/// Applies the preset first, then the flags. A method without a typed threshold gets the threshold with the same step in depth as the
/// preset's. Error: a lower threshold typed as a depth, an unknown preset, or values that contradict each other.
[[nodiscard]] Result<edges::Settings> settingsOf(const MethodFlags& flags);

/// Checks the flags as settingsFor() would, before a scan is open. From here on a preset file is an input (core/base/inputs.h).
[[nodiscard]] Result<Done> checkMethod(const MethodFlags& flags);

/// What the flags choose without saying so, a sentence each: the method, and settings of a preset that it does not use.
[[nodiscard]] std::vector<std::string> methodNotes(const MethodFlags& flags);

/// Like settingsOf(). A lower threshold typed as a depth ("0.5 m", "5 %") is computed for this scan.
[[nodiscard]] Result<edges::Settings> settingsFor(const MethodFlags& flags, const Scan& scan);

/// --frame --ascii --include-attached --operator --role: how to write clouds and records.
struct WriteFlags {
    std::string frame = "auto";
    bool ascii = false;
    bool includeAttached = false;
    std::string operatorName, role;
    files::WritingChoices choices;
};

/// A file that is to be written.
struct WantedExport {
    const exports::ExportKind* kind;
    std::string path;
};

/// The first of these flags without effect on any of the files: "ascii". Null: each changes one.
[[nodiscard]] const char* idleWriting(const WriteFlags& flags, std::span<const WantedExport> wanted);

/// The export options for one command. "auto" is files::usualFrame(); `file` is given where its format may hold no coordinates.
[[nodiscard]] exports::ExportOptions exportOptions(const WriteFlags& flags, const Scan& scan, const std::filesystem::path& file = {});

} // namespace edgescan::cli
