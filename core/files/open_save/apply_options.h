// What the operator gives on opening a scan and the file does not say, or says otherwise.
#pragma once

#include "core/files/point_tables/source.h"
#include "core/scan/grid/scan.h"

namespace edgescan::files {

/// The angles of the options, and unless the scan `placesItself` the place that --pose and --calibration give. Error: one of the two is
/// missing, or they do not fit the scan.
Result<Done> applyOptions(Scan& scan, const Source& source, bool placesItself);

/// The step for a whole sweep: with options.straighten the angles are corrected; else a warning reports beams or lines that are displaced.
[[nodiscard]] Scan straightenedAsAsked(Scan scan, const ReadingOptions& options);

} // namespace edgescan::files
