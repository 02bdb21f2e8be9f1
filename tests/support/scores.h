// The score in one call, for tests that need only the score.
#pragma once

#include "app/lab/score/score.h"

namespace edgescan::test {

inline lab::EdgeScore scoreEdges(const Grid<std::uint8_t>& mask, const sim::EdgeTruth& truth, double tolerance) {
    return lab::scoreMatches(lab::matchWithTruth(mask, truth, tolerance), truth);
}

} // namespace edgescan::test
