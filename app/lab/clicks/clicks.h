// Random clicks near the edges of a simulated scan: how many measurements are off by more than their stated uncertainty.
#pragma once

#include "app/lab/sim/simulate.h"
#include "core/base/order_statistic.h"

#include <cstdint>
#include <vector>

namespace edgescan::lab {

/// Lengths between one click and the next.
struct ClickedLengths {
    std::size_t refused = 0;     ///< one of the two clicks has no range, and so the operator gets a sentence
    std::size_t measured = 0;    ///< all others
    std::size_t off = 0;         ///< number of these that differ from the true length by more than their ±
    std::size_t offSilently = 0; ///< number of these without a warning
    std::size_t warned = 0; ///< number of all with a warning: an end is behind an edge, or another near side is within reach of a click
    std::size_t behind = 0; ///< number of these with an end on a surface behind the one that was meant
    std::size_t silent = 0; ///< number of these without a warning
    std::vector<double> tolerancesM; ///< the ± of all that are measured, m
    [[nodiscard]] double shareOff() const { return measured == 0 ? 0.0 : static_cast<double>(off) / static_cast<double>(measured); }

    /// 0 without lengths.
    [[nodiscard]] double medianToleranceM() const { return median(tolerancesM); }

    ClickedLengths& operator+=(const ClickedLengths& other);
};

struct ClickScore {
    std::size_t clicks = 0;
    std::size_t moved = 0;    ///< number of these that inspect::nearSideCell() moved
    ClickedLengths asClicked; ///< measured at the clicked cells
    ClickedLengths nearSide;  ///< measured where inspect::nearSideCell() puts them

    ClickScore& operator+=(const ClickScore& other);
};

/// The cells on the near side of a true edge (jump or void), in their order. The simulation must have its truth.
[[nodiscard]] std::vector<std::uint32_t> nearSides(const sim::Simulation& simulation);

/// Each click is a random cell within two cells of a random cell on the near side of a true edge (jump or void). The surface at that edge's
/// cell is meant. A length is compared with that between the true points of these surfaces nearest to the measured cells. The simulation
/// must have its truth, and recorded angles without errors. One seed gives the same clicks.
[[nodiscard]] ClickScore scoreClicks(const sim::Simulation& simulation, int clicks, std::uint64_t seed);

} // namespace edgescan::lab
