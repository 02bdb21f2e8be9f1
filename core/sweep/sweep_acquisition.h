// What a sweep's own telegrams say of who measured it and when.
#pragma once

#include "core/scan/acquisition.h"
#include "core/sweep/growing_sweep.h"

#include <memory>

namespace edgescan {

/// Of the first `rows` rows. Times count as UTC: recordings and live feeds stamp lines so.
[[nodiscard]] std::shared_ptr<const Acquisition> sweepAcquisition(GrowingSweep& sweep, std::size_t rows, const SweepSettings& settings);

} // namespace edgescan
