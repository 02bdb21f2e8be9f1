// What the steps of a sweep differ by anyway: the measure of whether a slip is proved.
#pragma once

#include "core/scan/grid/inverse_range.h"

namespace edgescan {

/// Index steps: 1.48 times the median size of what every few lines show, as lineSlips() measures it; lines whose surfaces say too little
/// are left out, and 0 where all are. Of a sweep whose slipped lines were brought to their places.
[[nodiscard]] float stepUnevenness(const InverseRange& inverse);

} // namespace edgescan
