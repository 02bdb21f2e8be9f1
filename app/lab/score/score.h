// Scores a mask against the true edges (docs/method/edges.md, "Truth and score").
#pragma once

#include "app/lab/score/match.h"
#include "app/lab/sim/truth/truth.h"

#include <vector>

namespace edgescan::lab {

/// Counts that can be added over scans.
struct EdgeCounts {
    std::size_t truth = 0;  ///< true cells of the group
    std::size_t found = 0;  ///< number of these that were matched
    std::size_t false_ = 0; ///< unmatched detections, without cells that are not scored; the same for all groups

    EdgeCounts& operator+=(const EdgeCounts& other);
    [[nodiscard]] double precision() const; ///< found / (found + false); 1 without detections
    [[nodiscard]] double recall() const;
    [[nodiscard]] double f() const;
};

struct EdgeScore {
    EdgeCounts occluding; ///< classes 1 + 4
    EdgeCounts outline;   ///< 1 + 2 + 4
    EdgeCounts crease;    ///< 3
    EdgeCounts all;
    EdgeCounts strictOutline; ///< outline, with detections on inner creases counted as false

    EdgeScore& operator+=(const EdgeScore& other);
};

/// Which detections found which true cells.
struct EdgeMatches {
    Grid<std::uint8_t> thin;          ///< the mask after thinning
    std::vector<MatchedPair> all;     ///< matched with all classes
    std::vector<MatchedPair> outline; ///< matched with the outline only
};

/// `mask`: 255 = edge; it is thinned here. `tolerance`: cells.
[[nodiscard]] EdgeMatches matchWithTruth(const Grid<std::uint8_t>& mask, const sim::EdgeTruth& truth, double tolerance);
[[nodiscard]] EdgeScore scoreMatches(const EdgeMatches& matches, const sim::EdgeTruth& truth);

} // namespace edgescan::lab
