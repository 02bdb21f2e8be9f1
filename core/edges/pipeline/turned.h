// What turning one parameter does to the others.
#pragma once

#include "core/edges/settings/parameters.h"

namespace edgescan {

/// `settings` after a person turned one parameter. Another method keeps the step in depth that `lastGray`, the last settings of a method on
/// gray levels, had as its threshold. A near that reaches far pushes it on, and the other way round: no invalid pair can be set.
[[nodiscard]] Settings turned(const Settings& settings, const Parameter& parameter, double value, const Settings& lastGray);

} // namespace edgescan
