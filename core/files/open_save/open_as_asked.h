// Opens a scan with everything that was asked for on opening it.
#pragma once

#include "core/files/open_save/open_scan.h"

namespace edgescan::files {

/// openScan(), and then what can be done only with the whole sweep: with options.straighten the angles are corrected, else a warning tells
/// where beams or lines lie elsewhere than they say. For whoever shows, exports or verifies scans.
Result<Scan> openAsAsked(const std::filesystem::path& path, const ReadingOptions& options = {});

} // namespace edgescan::files
