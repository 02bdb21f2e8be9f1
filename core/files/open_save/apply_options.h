// What the operator gives on opening a scan and the file does not say, or says otherwise.
#pragma once

#include "core/files/formats/format.h"
#include "core/scan/grid/scan.h"

namespace edgescan::files {

/// The angles of the options, and unless the scan `placesItself` the place that --pose and --calibration give. Error: one of the two is
/// missing, or they do not fit the scan.
Result<Done> applyOptions(Scan& scan, const Source& source, bool placesItself);

/// Options that only some formats have, on a scan of `format`: a warning for each. Error: --scan asks for a scan that the file does not
/// have.
Result<Done> checkOptions(Scan& scan, const ReadingOptions& options, const Format& format);

/// The step for a whole sweep: with options.straighten the angles are corrected; else a warning reports beams or lines that are displaced.
[[nodiscard]] Scan straightenedAsAsked(Scan scan, const ReadingOptions& options);

} // namespace edgescan::files
