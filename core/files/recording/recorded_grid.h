// What a scan holds beyond what telegrams can say, stored as JSON in a recording's metadata.
#pragma once

#include "core/base/result.h"
#include "core/scan/grid/scan.h"
#include "core/scanner/sweep_assembly/sweep_settings.h"

#include <string>

namespace edgescan::files {

/// Key of the metadata record "sweep" with the description of the grid (core/files/point_tables/description.h).
inline constexpr const char* kRecordedGridKey = "edgescan.grid";

/// Key that a recording made of another file carries: what that was.
inline constexpr const char* kMadeFromKey = "made_from";

/// Angles, states, unit and note as the metadata describe them, for as many lines as there are; the scan as it is when they do not.
Result<Scan> withRecordedGrid(Scan scan, const scanner::SweepMetadata& metadata, const std::string& where);

} // namespace edgescan::files
