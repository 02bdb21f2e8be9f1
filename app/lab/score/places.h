// Where detections are: how near to the true edges, and how far across them (docs/method/edges.md, "Truth and score").
#pragma once

#include "app/lab/sim/truth/truth_files.h"

#include <array>
#include <cstddef>

namespace edgescan::lab {

/// Distances that are counted, cells.
inline constexpr std::array<int, 3> kPlaceDistances{1, 2, 3};

/// For the true cells of one class; can be added over scans. A matching pairs each cell once and stretches pairs along the edge; here every
/// true cell looks for its nearest detection.
struct EdgePlaces {
    std::size_t truth = 0;                                  ///< scored true cells
    std::array<std::size_t, kPlaceDistances.size()> near{}; ///< those with a detection within each distance
    std::size_t measured = 0;                               ///< those whose nearest detection has an offset across the edge
    double across = 0.0;                                    ///< sum of these offsets, cells; positive: on the farther side

    EdgePlaces& operator+=(const EdgePlaces& other);
    [[nodiscard]] double share(std::size_t distance) const; ///< of the true cells, by index of kPlaceDistances; 1 without true cells
    [[nodiscard]] double offset() const;                    ///< mean, cells; 0 without any
};

/// By sim::EdgeClass, None unused.
using PlacesByClass = std::array<EdgePlaces, 5>;

/// `thin`: 255 = edge, one cell wide. The direction across an edge is that of its true cells around; the farther side that of the larger
/// range without noise two cells away, or of nothing. Without these ranges there are no offsets.
[[nodiscard]] PlacesByClass edgePlaces(const Grid<std::uint8_t>& thin, const sim::TruthSet& truth);

/// All classes together.
[[nodiscard]] EdgePlaces allPlaces(const PlacesByClass& places);

} // namespace edgescan::lab
