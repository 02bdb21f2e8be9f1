// Angles and mounting that whoever opens a scan gives: they win over what the file says or what was recognised.
#pragma once

#include "core/scan/grid/reading_options.h"

namespace edgescan {

/// Lines and beams at the angles given, as far as they are; nothing happens to an organised cloud.
void useGivenAngles(Scan& scan, const ReadingOptions& options);

} // namespace edgescan
