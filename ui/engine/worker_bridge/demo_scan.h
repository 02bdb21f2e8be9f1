// The demo draw-bell: simulated at the first start, then read from the cache folder.
#pragma once

#include "core/base/result.h"
#include "core/scan/grid/scan.h"

#include <functional>

namespace edgescan::ui {

/// 1141 x 1000 sweep of the scene `hangup`, or of the same bell after a blast. Any thread. False from `progress` cancels: Error
/// "cancelled".
[[nodiscard]] Result<Scan> demoScan(const std::function<bool(const char* stage, double fraction)>& progress, bool afterBlast = false);

} // namespace edgescan::ui
