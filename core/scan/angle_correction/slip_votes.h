// The displacement of a line, as each of its slanted cells shows it (a vote), and medians of these votes.
#pragma once

#include "core/scan/grid/inverse_range.h"
#include "core/scan/grid/marked_cells.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace edgescan {

inline constexpr float kLeastSlant = 0.005F; // change of u per line, as a share of u
inline constexpr float kMostSlant = 0.1F;    // a steeper change is an edge, not a slant
inline constexpr std::size_t kFewestCells = 16;
inline constexpr float kLargestSpread = 0.35F; // largest spread of the votes of a line, in index steps or as a share of the slip

/// How much the surfaces of a line slant across the lines.
struct LineSlants {
    explicit LineSlants(int beams) : slant(static_cast<std::size_t>(beams)), slanted(slant.size()) {}
    std::vector<float> slant;          ///< change of u per line
    std::vector<std::uint8_t> slanted; ///< 1 where the slant is large enough and the cell is not on an edge

    /// Calls visit(beam, slant) where the line is slanted.
    template <class Visit>
    void forEach(Visit visit) const {
        forEachMarked(slanted, [&](std::size_t beam) { visit(static_cast<int>(beam), slant[beam]); });
    }
};

/// The displacement that one cell shows.
struct SlipVote {
    float steps; ///< index steps
    float weight;
    float slant = 0; ///< of u per line
};

/// Whether a cell and all eight cells around it were measured. All nine must be inside the sweep.
[[nodiscard]] bool measuredAround(const InverseRange& inverse, int line, int beam);

/// The share by which the deviations from straight lines shrink when a slip of `steps` is removed. Near 0 if the deviations are only noise.
[[nodiscard]] float explainedShare(const std::vector<SlipVote>& slips, float steps);

/// Whether the weighted median is between -limit and limit, as on most lines; faster than computing the median.
[[nodiscard]] bool isMedianWithin(float limit, const std::vector<SlipVote>& slips);

/// The weighted median: the least value at which the votes up to it hold half of the weight.
[[nodiscard]] float weightedMedian(std::vector<SlipVote> slips);

/// Weighted median of the distances from `value`.
[[nodiscard]] float spreadAround(float value, std::vector<SlipVote> slips);

} // namespace edgescan
