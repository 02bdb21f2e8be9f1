// The demo draw-bell, which the build simulates once.
#pragma once

#include "core/base/result.h"
#include "core/scan/grid/scan.h"

#include <functional>

namespace edgescan::ui {

/// A sweep of 1141 x 1000 cells of the scene `hangup`, or of the same bell after a blast. Any thread. `progress` returning false cancels:
/// Error "cancelled", or the error of openScan().
[[nodiscard]] Result<Scan> demoScan(const std::function<bool(const char* stage, double fraction)>& progress, bool afterBlast = false);

} // namespace edgescan::ui
