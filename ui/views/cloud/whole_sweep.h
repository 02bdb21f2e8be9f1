// The outline of a sweep that has only begun.
#pragma once

#include "ui/views/cloud/cloud_geometry.h"

#include <memory>

namespace edgescan::ui {

/// A coarse cloud in the directions of all lines of a sweep, at the median range of its first ones: a view that shows it need not move
/// while the sweep grows. `expectedLines` 0: not known, half a turn. Null: fewer than two lines, or no line angles.
[[nodiscard]] std::shared_ptr<const CloudGeometry> wholeSweep(const Scan& scan, int expectedLines);

} // namespace edgescan::ui
