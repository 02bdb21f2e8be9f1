// A scan as a recording: its lines encoded as telegrams, the stepper's reports carrying the exact line angles.
#pragma once

#include "core/base/result.h"
#include "core/containers/mcap/records.h"
#include "core/scan/grid/scan.h"

#include <string>

namespace edgescan::files {

/// Opens again as the same ranges, states and angles. Error: a range is not a whole count of unitMm up to 65535, the scan has no angles,
/// or more beams or lines than telegrams can carry. `where` goes into the error.
Result<Bytes> recordingOf(const Scan& scan, const std::string& where);

} // namespace edgescan::files
