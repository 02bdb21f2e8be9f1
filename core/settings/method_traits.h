// What sets the methods apart.
#pragma once

#include "core/settings/settings.h"

namespace edgescan {

/// Roberts, Sobel, Prewitt, Kirsch, Robinson, MarrHildreth, Log: an edge is where the response is larger than settings.lower.
[[nodiscard]] bool hasOneThreshold(Method method);

/// Marr-Hildreth smooths by itself: it wants the gray levels as they are. All others take them smoothed.
[[nodiscard]] bool smoothsItself(Method method);

} // namespace edgescan
