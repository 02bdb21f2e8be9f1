// The normal unevenness of the stepper's steps: the measure for deciding whether a slip is proved.
#pragma once

#include "core/scan/grid/inverse_range.h"

namespace edgescan {

/// Index steps: 1.48 times the median size of the displacements that a sample of the lines shows, as lineSlips() measures them. Lines with
/// too few slanted cells are left out; 0 if all are. `inverse` is a sweep after its slipped lines were moved to their places.
[[nodiscard]] float stepUnevenness(const InverseRange& inverse);

} // namespace edgescan
