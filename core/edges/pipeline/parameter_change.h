// The effect of changing one parameter on the others.
#pragma once

#include "core/edges/settings/parameters.h"

namespace edgescan::edges {

/// `settings` after a person changed one parameter. Another method gets the step in depth that `lastGray`, the last settings of a method on
/// gray levels, had as its threshold. If near is set beyond far, far is moved, and the other way round, so that the pair is always valid.
[[nodiscard]] Settings withParameterChanged(const Settings& settings, const Parameter& parameter, double value, const Settings& lastGray);

} // namespace edgescan::edges
