// What the slanted cells of a line say of its displacement, each for itself.
#pragma once

#include "core/scan/marked_cells.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace edgescan {

inline constexpr float kLeastSlant = 0.005F; // change of u per line, share of u
inline constexpr float kMostSlant = 0.1F;    // steeper is an edge rather than a slant
inline constexpr std::size_t kFewestCells = 16;
inline constexpr float kAgree = 0.35F; // spread of the values of a line, index steps or share of the slip

// What the cells of a line tell of its slant.
struct LineSlants {
    explicit LineSlants(int beams) : slant(static_cast<std::size_t>(beams)), slanted(slant.size()) {}
    std::vector<float> slant;          ///< change of u per line
    std::vector<std::uint8_t> slanted; ///< 1 where it is slanted enough and no edge

    /// Calls visit(beam, slant) where the line is slanted.
    template <class Visit>
    void forEach(Visit visit) const {
        forEachMarked(slanted, [&](std::size_t beam) { visit(static_cast<int>(beam), slant[beam]); });
    }
};

/// One cell's displacement.
struct SlipVote {
    float steps; ///< index steps
    float weight;
    float slant = 0; ///< of u per line
};

/// How much smaller the deviations from straight get when the slip is taken out, 0..1: noise does not shrink.
[[nodiscard]] float explained(const std::vector<SlipVote>& slips, float steps);

/// Whether the weighted median lies between -limit and limit, as it does on most lines.
[[nodiscard]] bool isMiddleWithin(float limit, const std::vector<SlipVote>& slips);

/// The weighted median: the least value up to which half of the weight lies.
[[nodiscard]] float weightedMiddle(std::vector<SlipVote> slips);

/// Weighted median distance from `value`.
[[nodiscard]] float spreadAround(float value, std::vector<SlipVote> slips);

} // namespace edgescan
