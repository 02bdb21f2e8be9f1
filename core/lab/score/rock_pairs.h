// Which of two neighbouring rocks lies in front, and which touch (docs/method.md, "Truth and score").
#pragma once

#include "core/lab/score/rock_score.h"
#include "core/lab/score/rock_truth.h"

#include <vector>

namespace edgescan {

/// Two rocks, or two regions, that lie beside each other in the picture; a < b.
struct RockPair {
    std::uint32_t a = 0, b = 0;
    std::uint32_t front = 0; ///< a or b: that one lies before the other; 0 = neither, or it cannot be told
    bool contact = false;    ///< they touch where it can be seen
};

/// By numbers of TrueRocks::rock, in order. One lies in front where at least 3 neighbouring cells of the two are torn apart by over 50 mm
/// and 80 % of them one way; they touch where at least 5 are not torn. Empty where the truth tells no tears.
[[nodiscard]] std::vector<RockPair> truePairs(const TrueRocks& truth);

/// Counts over pairs of found rocks; can be added.
struct PairCounts {
    std::size_t told = 0;       ///< pairs of regions that match rocks, for which something is told
    std::size_t known = 0;      ///< pairs of found rocks for which it is true
    std::size_t toldKnown = 0;  ///< both
    std::size_t right = 0;      ///< of these, told as it is (in front: the right one)
    std::size_t rocks = 0;      ///< found
    std::size_t rocksClose = 0; ///< of them, number told within one of the true number among found rocks

    PairCounts& operator+=(const PairCounts& other);
};
struct PairScore {
    PairCounts order, contacts;
    PairScore& operator+=(const PairScore& other);
};

/// `match` says which region is which rock; `told` are pairs of regions.
[[nodiscard]] PairScore scorePairs(const std::vector<RockPair>& truth, const std::vector<RockPair>& told, const RockMatch& match);

} // namespace edgescan
