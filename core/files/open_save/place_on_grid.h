// From what a reader found to a scan.
#pragma once

#include "core/files/formats/reading.h"

namespace edgescan::files {

/// A scan stays as it is. Points become a scan by the first of these that fits: the grid in the sidecar of the file, our own
/// description in the file, and the grid that the points themselves show. Then the place and the names that the file states are added.
Result<Scan> placeOnGrid(Reading reading, const Source& source);

} // namespace edgescan::files
