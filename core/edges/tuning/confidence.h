// How robust each edge is against small changes of the settings. It distinguishes edges that appear at one setting only from those that
// appear at all of them.
#pragma once

#include "core/edges/pipeline/detection.h"

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace edgescan::edges {

inline constexpr double kVariationFactor = 1.1; ///< factor by which the threshold and each other number is multiplied and divided

/// The settings of the detection first, then those near them. Each number that affects the edges is multiplied and divided by
/// kVariationFactor (automatic ones start from their value on this scan), or changed by one step of its slider if that is more. Each size
/// is taken one larger and one smaller. With each of these settings the threshold is also multiplied and divided.
[[nodiscard]] std::vector<Settings> nearbySettings(const Detection& detection);

/// Immutable after construction.
struct EdgeConfidence {
    /// lines x beams: percentage of the tried settings, rounded down, with an edge in the cell or next to it; 0 where the detection has no
    /// edge
    Grid<std::uint8_t> percent;
    int settings = 0; ///< number of settings tried
};

/// The confidence of the edges of a detection; computes the edges for all nearby settings. `goOn` is called with the share done (0 to 1).
/// Empty if it returns false.
[[nodiscard]] std::optional<EdgeConfidence> edgeConfidence(const Detection& detection, const std::function<bool(double done)>& goOn = {});

/// Bands of percentages, the same everywhere: an edge belongs to the first of these that it reaches.
inline constexpr std::array<int, 5> kConfidenceBands{100, 90, 70, 50, 0};
[[nodiscard]] std::size_t confidenceBand(int percent);

} // namespace edgescan::edges
