// The displacement of a line as each of its slanted cells shows it.
#pragma once

#include "core/scan/grid/inverse_range.h"
#include "core/scan/grid/marked_cells.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace edgescan {

inline constexpr float kLeastSlant = 0.005F; // change of u per line, share of u
inline constexpr float kMostSlant = 0.1F;    // steeper is an edge rather than a slant
inline constexpr std::size_t kFewestCells = 16;
inline constexpr float kAgree = 0.35F; // spread of the values of a line, index steps or share of the slip

/// How the surfaces of a line slant across the lines.
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

/// Whether a cell and all around it were measured; none of them may be outside of the sweep.
[[nodiscard]] bool measuredAround(const InverseRange& inverse, int line, int beam);

/// By which share the deviations from straight shrink when a slip of so many steps is taken out. Near 0 when they are only noise.
[[nodiscard]] float explained(const std::vector<SlipVote>& slips, float steps);

/// Whether the weighted median lies between -limit and limit, as on most lines; faster than the median itself.
[[nodiscard]] bool isMiddleWithin(float limit, const std::vector<SlipVote>& slips);

/// The weighted median: the least value up to which half of the weight lies.
[[nodiscard]] float weightedMiddle(std::vector<SlipVote> slips);

/// Weighted median distance from `value`.
[[nodiscard]] float spreadAround(float value, std::vector<SlipVote> slips);

} // namespace edgescan
