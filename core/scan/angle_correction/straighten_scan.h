// Corrects the angles of a sweep whose beams were interlaced or whose stepper slipped. The corrections are measured on the surfaces of the
// sweep itself.
#pragma once

#include "core/scan/grid/scan.h"

#include <optional>
#include <string>

namespace edgescan {

/// If the lines have different beam phases in a cycle, the lines of each cycle become one line, and nothing else is changed. Otherwise the
/// angles are corrected: odd and even beams get half of their displacement each as a skew of the line angle, and all lines behind a slip
/// are moved by the slip. Ranges and states are unchanged. A warning says what was moved, or that nothing was found. A slip that only every
/// second beam shows is reported but not corrected. Displacements that the angles already contain are not corrected again. Clouds without
/// beam angles are unchanged and get a warning.
[[nodiscard]] Scan straightened(Scan scan);

/// A sentence for a scan that was not straightened: which beams or lines were measured at other angles than recorded, by how much, and what
/// to do. Empty if nothing was found, and for clouds without beam angles.
[[nodiscard]] std::optional<std::string> displacementWarning(const Scan& scan);

/// Whether `warning` is a sentence of displacementWarning().
[[nodiscard]] bool isDisplacementWarning(const std::string& warning);

} // namespace edgescan
