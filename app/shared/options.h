// Flags that several commands share: how a file is read, which settings the method gets, and how progress is told.
#pragma once

#include "app/shared/exits.h"
#include "app/shared/numbers.h"
#include "app/shared/typed_settings.h"
#include "core/base/result.h"
#include "core/exports/provenance/provenance.h"
#include "core/files/open_save/open_scan.h"
#include "core/scan/grid/scan.h"

#include <CLI/CLI.hpp>

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

/// What was found and where it was written, on stderr, for whoever sits there: where that is a terminal or --progress is given.
void tellWritten(const std::string& sentence, const ReadFlags& flags);

/// The scan; what was assumed, repaired or left out on reading is said on stderr, beside the result that follows.
[[nodiscard]] Result<Scan> openAndTell(const std::string& file, const ReadFlags& flags);

/// --frame --ascii --include-attached --operator --role, and the choices of formats.
void addWriteFlags(CLI::App& command, WriteFlags& flags);

/// --preset and one flag per row of the parameter table, into `flags`.
void addMethodFlags(CLI::App& command, MethodFlags& flags);

} // namespace edgescan::cli
