// Throats of a simulated scan, clicked several times: how far their widths depend on the clicks.
#pragma once

#include "app/lab/sim/simulate.h"
#include "core/base/order_statistic.h"

#include <cstdint>
#include <vector>

namespace edgescan::lab {

/// Widths of the same openings by clicks that differ by up to two cells.
struct ThroatWidths {
    std::size_t refused = 0;     ///< clicks that find no way, and so the operator gets a sentence
    std::size_t measured = 0;    ///< all others
    std::size_t off = 0;         ///< number of these that differ from the opening's first width by more than their ±
    std::size_t equal = 0;       ///< openings where all clicks find the same two ends
    std::vector<double> spreads; ///< of each opening: the largest width less the smallest one, as a share of the first

    [[nodiscard]] double shareOff() const { return measured == 0 ? 0.0 : static_cast<double>(off) / static_cast<double>(measured); }
    /// 0 without openings.
    [[nodiscard]] double medianSpread() const { return median(spreads); }
    ThroatWidths& operator+=(const ThroatWidths& other);
};

struct ThroatScore {
    ThroatWidths ofClicks; ///< narrowestBetween() of the two cells that the clicks mean
    ThroatWidths ofAround; ///< throatAt(): also with clicks next to them
    ThroatWidths ofOne;    ///< throatThrough() of one click into the opening, halfway between the two

    ThroatScore& operator+=(const ThroatScore& other);
};

/// An opening: from a random cell on the near side of a true edge (jump or void) along one of eight directions, over cells that are farther
/// away or have no range, to the next cell about as near. Each opening is clicked at these two cells, then `repeats` times up to two cells
/// from them. The simulation must have its truth. One seed gives the same clicks.
[[nodiscard]] ThroatScore scoreThroats(const sim::Simulation& simulation, int openings, int repeats, std::uint64_t seed);

} // namespace edgescan::lab
