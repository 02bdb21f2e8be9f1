// A sweep whose beams were interlaced or whose stepper slipped, with the angles that its own surfaces tell.
#pragma once

#include "core/scan/grid/scan.h"

#include <optional>
#include <string>

namespace edgescan {

/// Lines of different beam phases in turn become one line each turn, and nothing else is done. Else corrects the angles: odd and even beams
/// get half of their displacement each as a skew of the line angle, and all lines behind a slip are moved on by it. Ranges and states stay.
/// A warning says what was moved, or that nothing was found. A slip that only every second beam shows is told and left. What the angles
/// allow for already is not moved again. Clouds without beam angles stay as they are, with a warning.
[[nodiscard]] Scan straightened(Scan scan);

/// A sentence for a scan that was not straightened: which beams or lines lie elsewhere than their angles say, by how much, and what to do.
/// Empty where nothing was found, and for clouds without beam angles.
[[nodiscard]] std::optional<std::string> displacementWarning(const Scan& scan);

/// Whether this is the sentence of displacementWarning().
[[nodiscard]] bool tellsOfDisplacement(const std::string& warning);

} // namespace edgescan
