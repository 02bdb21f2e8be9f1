// Recognises scans for which the preset "smooth-walls" is made.
#pragma once

#include "core/edges/pipeline/detection.h"

namespace edgescan::edges {

/// True if the surfaces are flat and the ranges quiet, so that the smallest jump need not grow with the range: hardly a cell folds, and
/// the noise at 5 m is at most that of the reference scanner. False for methods that measure no folds.
[[nodiscard]] bool isFlatAndQuiet(const Detection& detection);

} // namespace edgescan::edges
