// Which of two neighbouring rocks is in front, and which rocks touch (docs/method/edges.md, "Truth and score").
#pragma once

#include "app/lab/score/rock_score.h"
#include "app/lab/score/rock_truth.h"

#include <vector>

namespace edgescan::lab {

/// Two rocks, or two regions, that are neighbours in the picture; a < b.
struct RockPair {
    std::uint32_t a = 0, b = 0;
    std::uint32_t front = 0; ///< a or b: that one is in front of the other; 0 = neither, or unknown
    bool contact = false;    ///< they visibly touch
};

/// By numbers of TrueRocks::rock, in order. One rock is in front if at least 3 pairs of neighbouring cells have a step over 50 mm and 80 %
/// of these are in the same direction. Two rocks touch if at least 5 pairs have no such step. Empty if the truth has no tears.
[[nodiscard]] std::vector<RockPair> truePairs(const TrueRocks& truth);

/// Counts over pairs of found rocks; can be added.
struct PairCounts {
    std::size_t reported = 0;      ///< pairs of regions that match rocks, with a reported statement
    std::size_t known = 0;         ///< pairs of found rocks for which the statement is true
    std::size_t reportedKnown = 0; ///< pairs that are in both
    std::size_t right = 0;         ///< of these, reported correctly (in front: the right one)
    std::size_t rocks = 0;         ///< rocks found
    std::size_t rocksClose = 0;    ///< of these, rocks whose reported number is within one of the true number among found rocks

    PairCounts& operator+=(const PairCounts& other);
};
struct PairScore {
    PairCounts order, contacts;
    PairScore& operator+=(const PairScore& other);
};

/// `match` assigns regions to rocks; `reported` are the reported pairs of regions.
[[nodiscard]] PairScore scorePairs(const std::vector<RockPair>& truth, const std::vector<RockPair>& reported, const RockMatch& match);

} // namespace edgescan::lab
