// Ground truth of edges, from the simulator's data (docs/method/edges.md, "Truth and score").
#pragma once

#include "app/lab/sim/simulate.h"

#include <cstdint>

namespace edgescan::sim {

/// Values of EdgeTruth::edgeClass and of gt_class.png.
enum class EdgeClass : std::uint8_t {
    None = 0,
    Occluding = 1, ///< nearer cell of a pair whose tangent planes do not meet between the rays and are more than 50 mm apart
    Contact = 2,   ///< another object, without a jump, dihedral over 15 degrees
    Crease = 3,    ///< same object, dihedral over 30 degrees from one cell to the next; a wider rounding does not count as a crease
    Void = 4,      ///< last hit before an open void
};

struct EdgeTruth {
    Grid<std::uint8_t> edgeClass; ///< lines x beams, EdgeClass, thinned to one cell
    /// lines x beams, 255: not scored; among others rounded folds that bend by 30 degrees within 4 cells but not within one
    Grid<std::uint8_t> ignore;
};

[[nodiscard]] EdgeTruth edgeTruth(const SimulationTruth& truth);

} // namespace edgescan::sim
