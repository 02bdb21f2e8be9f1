// How well each edge holds when the settings are turned a little: what is an edge at one setting only is told from what is one at all of
// them.
#pragma once

#include "core/edges/pipeline/detection.h"

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace edgescan {

inline constexpr double kTurnedBy = 1.1; ///< what the threshold and each other number is multiplied and divided by

/// Those of the detection first, then what lies near them: each number that the method finds edges by multiplied and divided by kTurnedBy
/// (automatic ones from where they came out), or turned by one step of its slider where that is more, each size one larger and one smaller;
/// and the threshold turned likewise with each of these.
[[nodiscard]] std::vector<Settings> nearbySettings(const Detection& detection);

/// Never changed after it is made.
struct EdgeConfidence {
    Grid<std::uint8_t> percent; ///< lines x beams: of the settings tried, rounded down, those with an edge in the cell or next to it;
                                ///< 0 where the detection has no edge
    int settings = 0;           ///< how many were tried
};

/// Of the edges of a detection, all of whose settings are worked out again. Empty when `goOn`, which is told how much is done (0 to 1),
/// says false.
[[nodiscard]] std::optional<EdgeConfidence> edgeConfidence(const Detection& detection, const std::function<bool(double done)>& goOn = {});

/// The same percentages everywhere: an edge belongs to the first of these that it reaches.
inline constexpr std::array<int, 5> kConfidenceBands{100, 90, 70, 50, 0};
[[nodiscard]] std::size_t confidenceBand(int percent);

} // namespace edgescan
