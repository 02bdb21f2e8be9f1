// The gradient detectors of the thesis's chapter 3: two or eight small masks, and the strength of their response.
#pragma once

#include "core/edges/gray/neighbours.h"
#include "core/edges/settings/settings.h"

#include <cstdint>
#include <optional>

namespace edgescan::edges {

// The responses take gray levels (raw or smoothed), lines x beams, and the missing cells (255; may be null). A missing cell in a window
// counts as the window's centre, and has no response itself. The responses are divided by the sums of the masks.

/// The direction in which the levels increase at a cell.
struct MaskDirection {
    std::optional<double> alongBeams{}; ///< components in the units of the response, for detectors that have them; either both or neither
    std::optional<double> alongLines{};
    std::optional<double> deg{}; ///< 0 along increasing beams, 90 along increasing lines; empty where the levels are equal
};

/// The responses of two masks, with their strength and direction.
struct MaskComponents {
    int alongBeams, alongLines;
};
[[nodiscard]] float strengthOf(MaskComponents answers, Norm norm);
[[nodiscard]] MaskDirection directionOf(MaskComponents answers, double share = 1.0);

/// The mask -c 0 c / -m 0 m / -c 0 c and its transpose. Sobel (1968): c = 1, m = 2. Prewitt (1970): 1, 1.
template <int kCorner, int kMiddle>
[[nodiscard]] MaskComponents differencesOfThree(const Neighbours& at) {
    const auto& n = at.around;
    return {kCorner * (n[2] + n[4] - n[0] - n[6]) + kMiddle * (n[3] - n[7]),
            kCorner * (n[6] + n[4] - n[0] - n[2]) + kMiddle * (n[5] - n[1])};
}
template <int kCorner, int kMiddle>
[[nodiscard]] Grid<float> threeByThreeResponse(const Grid<std::uint8_t>& levels, const Grid<std::uint8_t>* missing,
                                               const Settings& settings) {
    const Norm norm = settings.norm;
    return responseOfNeighbours(levels, missing,
                                [=](const Neighbours& at) { return strengthOf(differencesOfThree<kCorner, kMiddle>(at), norm); });
}
template <int kCorner, int kMiddle>
[[nodiscard]] MaskDirection threeByThreeDirection(const Neighbours& at) {
    return directionOf(differencesOfThree<kCorner, kMiddle>(at));
}

/// Roberts (1963): differences along both diagonals, level(i, j) - level(i + 1, j + 1) and level(i, j + 1) - level(i + 1, j).
[[nodiscard]] Grid<float> robertsResponse(const Grid<std::uint8_t>& levels, const Grid<std::uint8_t>* missing, const Settings& settings);
[[nodiscard]] MaskDirection robertsDirection(const Neighbours& at);

/// Kirsch (1971): the strongest of eight masks, -3 -3 5 / -3 0 5 / -3 -3 5 rotated by 45 degrees each.
[[nodiscard]] Grid<float> kirschResponse(const Grid<std::uint8_t>& levels, const Grid<std::uint8_t>* missing, const Settings& settings);
/// The direction of the strongest mask, a multiple of 45 degrees.
[[nodiscard]] MaskDirection kirschDirection(const Neighbours& at);

/// Robinson (1977): the strongest of eight masks, -1 0 1 / -2 0 2 / -1 0 1 rotated by 45 degrees each.
[[nodiscard]] Grid<float> robinsonResponse(const Grid<std::uint8_t>& levels, const Grid<std::uint8_t>* missing, const Settings& settings);
[[nodiscard]] MaskDirection robinsonDirection(const Neighbours& at);

} // namespace edgescan::edges
