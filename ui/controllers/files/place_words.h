// The place of a scan in words, for the form of pose and mounting.
#pragma once

#include "core/scan/georef/calibration.h"
#include "core/scan/grid/scan.h"

#include <QString>

namespace edgescan::ui {

/// The scanner, where it looks, and the span of its points in the mine grid; in a line of its own, with ▲, what does not fit the mounting.
/// The scan must have a placement.
[[nodiscard]] QString placeWords(const Scan& scan, Viewing viewing);

} // namespace edgescan::ui
