// The gradient detectors of the thesis's chapter 3: two or eight small masks, and the strength of their answer.
#pragma once

#include "core/base/grid.h"
#include "core/settings/settings.h"

#include <cstdint>
#include <optional>

namespace edgescan {

// All take gray levels (as they are, or smoothed), lines x beams, and the cells without a valid range (255; may be null): a missing cell in
// a window counts as the window's cell, and has no response itself. All give the response of every cell in the units of the masks' sums.

/// Roberts (1963): differences along both diagonals, level(i, j) - level(i + 1, j + 1) and level(i, j + 1) - level(i + 1, j).
[[nodiscard]] Grid<float> robertsResponse(const Grid<std::uint8_t>& levels, const Grid<std::uint8_t>* missing, Norm norm);

/// Sobel (1968): masks -1 0 1 / -2 0 2 / -1 0 1 and its transpose.
[[nodiscard]] Grid<float> sobelResponse(const Grid<std::uint8_t>& levels, const Grid<std::uint8_t>* missing, Norm norm);

/// Prewitt (1970): masks -1 0 1 / -1 0 1 / -1 0 1 and its transpose.
[[nodiscard]] Grid<float> prewittResponse(const Grid<std::uint8_t>& levels, const Grid<std::uint8_t>* missing, Norm norm);

/// Kirsch (1971): the strongest of eight masks, -3 -3 5 / -3 0 5 / -3 -3 5 turned by 45 degrees each.
[[nodiscard]] Grid<float> kirschResponse(const Grid<std::uint8_t>& levels, const Grid<std::uint8_t>* missing);

/// Robinson (1977): the strongest of eight masks, -1 0 1 / -2 0 2 / -1 0 1 turned by 45 degrees each.
[[nodiscard]] Grid<float> robinsonResponse(const Grid<std::uint8_t>& levels, const Grid<std::uint8_t>* missing);

/// Which way the levels rise at a cell.
struct MaskDirection {
    std::optional<double> alongBeams; ///< components where the detector has them, in the units of the response; both, or none
    std::optional<double> alongLines;
    std::optional<double> deg; ///< 0 along increasing beams, 90 along increasing lines; empty where the levels are even
};
/// For the strongest mask of Kirsch and Robinson a multiple of 45 degrees; nothing for Marr-Hildreth and Log, whose zero crossings have no
/// direction, nor where the cell is missing.
[[nodiscard]] MaskDirection maskDirection(Method method, const Grid<std::uint8_t>& levels, const Grid<std::uint8_t>* missing, int line,
                                          int beam);

} // namespace edgescan
