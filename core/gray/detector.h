// Every detector of the thesis's chapter 3 that has one threshold, by its method.
#pragma once

#include "core/base/grid.h"
#include "core/settings/settings.h"

#include <cstdint>

namespace edgescan {

/// Response of every cell, lines x beams, in the sums of the detector's masks (for Marr-Hildreth and Log: the slope of the zero crossing);
/// 0 where a cell is missing. `levels`: gray, smoothed or not; `missing`: 255 = no valid range, may be null. Only for methods with one
/// threshold.
[[nodiscard]] Grid<float> detectorResponse(Method method, const Grid<std::uint8_t>& levels, const Grid<std::uint8_t>* missing,
                                           const Settings& settings);

/// 255 where the response is larger than the threshold.
[[nodiscard]] Grid<std::uint8_t> beyondThreshold(const Grid<float>& response, double threshold);

/// 255 = edge, lines x beams.
[[nodiscard]] Grid<std::uint8_t> detectorMask(Method method, const Grid<std::uint8_t>& levels, const Grid<std::uint8_t>* missing,
                                              const Settings& settings);

} // namespace edgescan
