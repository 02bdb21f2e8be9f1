// Jumps along a row of cells: where one visible surface ends and another begins. From the ranges alone, whatever the method and its
// settings.
#pragma once

#include "core/scan/grid/scan.h"

#include <array>
#include <span>
#include <vector>

namespace edgescan::inspect {

/// A jump between two cells of a row. Cells between the two have no range, or a range between the two surfaces (mixed pixels).
struct RowJump {
    int from = 0;       ///< index in the row
    int to = 0;         ///< index, larger than `from`
    double stepM = 0.0; ///< how much farther `to` is than the continued surface of `from`; negative: nearer

    [[nodiscard]] int nearer() const { return stepM > 0.0 ? from : to; }
    [[nodiscard]] int farther() const { return stepM > 0.0 ? to : from; }
};

/// Smallest jump between neighbours at a range, on a surface that faces the scanner; metres.
[[nodiscard]] double leastJumpM(double rangeM);

/// `rangesM`: of consecutive cells in one direction, 0 where a cell has none. A jump is where the straight lines in inverse range through
/// the cells before and behind do not meet between them, and miss each other by more than leastJumpM() and a tenth of the slope. Up to two
/// cells with a range may be between its ends, and up to `widestGap` cells without. Ordered by `from`; no jump contains another.
[[nodiscard]] std::vector<RowJump> jumpsAlong(std::span<const double> rangesM, int widestGap, double ofLimit = 1.0);

/// A cell, the next one in a direction, and the cells before and behind that decide whether there is a jump between them.
struct CellsAround {
    static constexpr int kReach = 4;
    std::array<double, 2 * kReach + 2> rangesM{}; ///< the cell is at kReach, the next one behind it
};
[[nodiscard]] CellsAround cellsAround(const Scan& scan, int line, int beam, int lineStep, int beamStep);

/// True if the cell and the next one in this direction have ranges, and no jump is between them.
[[nodiscard]] bool isOneSurface(const Scan& scan, int line, int beam, int lineStep, int beamStep);

} // namespace edgescan::inspect
