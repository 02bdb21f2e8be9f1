// The surface across a cell as a picture has it: the points along its line or across the lines, and a straight line through each side.
#pragma once

#include "core/edges/edgescan_plus/range_field.h"
#include "core/scan/grid/scan.h"

#include <array>
#include <optional>
#include <vector>

namespace edgescan {

/// In the plane of the beams: `across` at right angles to the cell's own beam, `away` along it, both metres from the cell.
struct ProfilePoint {
    std::size_t cell = 0;
    int side = 0; ///< -1 or 1: before or behind the cell; 0: the cell itself
    double acrossM = 0.0;
    double awayM = 0.0;
};
struct ProfileLine {
    double fromAcrossM = 0.0, fromAwayM = 0.0, toAcrossM = 0.0, toAwayM = 0.0;
    int points = 0; ///< that it was laid through
};
struct EdgeProfile {
    Along along = Along::Beams;
    std::vector<ProfilePoint> points;                ///< in order; without the cells that have no range
    std::array<std::optional<ProfileLine>, 2> sides; ///< before and behind the cell; empty where fewer than 3 points lie there
};

/// Up to `reach` cells to either side; lines are laid through the 6 nearest of a side with the smallest sum of squares across them.
/// Empty where the cell has no range.
[[nodiscard]] EdgeProfile edgeProfile(const Scan& scan, std::size_t k, Along along, int reach = 12);

} // namespace edgescan
