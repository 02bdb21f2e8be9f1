// The threshold that a method is mostly turned by, and what every other value of it would have given on the same detection.
#pragma once

#include "core/gray/gradient.h"
#include "core/gray/threshold_map.h"
#include "core/method/detection.h"

namespace edgescan {

/// "lower", "step" or "sensitivity": the key of the parameter that thresholdMapOf() sweeps.
[[nodiscard]] const char* sweptParameter(Method method);

/// Every threshold of a detection's method at once, all other settings as they are. As costly as a run of the method.
[[nodiscard]] ThresholdMap thresholdMapOf(const Detection& detection);

/// The threshold map of a detection with settings `a` also holds for `b`: nothing but the swept threshold differs.
[[nodiscard]] bool sameThresholdMap(const Settings& a, const Settings& b);

/// The gradient that Canny suppressed (on gray levels or on log range). Only for these two methods.
[[nodiscard]] Gradient gradientOf(const Detection& detection);

} // namespace edgescan
