// A sweep whose beams were interlaced or whose stepper slipped, with the angles that its own surfaces tell.
#pragma once

#include "core/scan/scan.h"

#include <optional>
#include <string>

namespace edgescan {

/// The angles corrected by what core/straighten/interlace.h measures: odd and even beams get half of their displacement each as a skew of the
/// line angle, lines behind a slip are moved on by it. Ranges and states stay. A warning says what was moved, or that nothing was found;
/// a slip seen in every second beam only is told and left. What the
/// angles tell of already is not moved again. Clouds without beam angles stay as they are, with a warning.
[[nodiscard]] Scan straightened(Scan scan);

/// What a scan that was not straightened should be told of: beams or lines that lie elsewhere than their angles say, by how much, and what
/// to do. Null where nothing was found, and for clouds without beam angles.
[[nodiscard]] std::optional<std::string> displacementWarning(const Scan& scan);

/// Whether a warning of a scan is the one above.
[[nodiscard]] bool tellsOfDisplacement(const std::string& warning);

} // namespace edgescan
