// The place of a scan that its own file states: a turn and a shift, as a surveyor registered it.
#pragma once

#include "core/files/formats/reading.h"
#include "core/files/grid_recovery/free_axis.h"

namespace edgescan::files {

/// Gives the scan that place, in metres unless --unit says otherwise. Does nothing when the scan has a place already, or when this one
/// neither moves nor turns; a warning says why where the numbers are not a rotation and a place on earth.
void placeAsWritten(Scan& scan, const WrittenPlace& written, const Source& source);

/// Gives the scan the place that its points show; a warning has it, and how well it fits. `metres` per number of the file.
void placeAsFound(Scan& scan, const FreeAxis& found, double metres);

} // namespace edgescan::files
