// What the user said on opening a scan, as JSON by flag name: provenance keeps it, so that the scan can be opened the same way again.
#pragma once

#include "core/base/result.h"
#include "core/io/open_scan.h"

#include <string>

namespace edgescan {

/// {"unit-mm": 10.0, "axis": "sweep", ...}: only what was said; empty when that is nothing.
[[nodiscard]] std::string openOptionsText(const OpenOptions& options);

/// The options back; an empty text gives the defaults. Error: damaged, or an unknown key. `where` goes into it.
Result<OpenOptions> parseOpenOptions(const std::string& json, const std::string& where);

} // namespace edgescan
