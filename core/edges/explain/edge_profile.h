// A profile of the surface at a cell for display: the points along its line or across the lines, and a straight line through each side.
#pragma once

#include "core/edges/edgescan_plus/range_field.h"
#include "core/scan/grid/scan.h"

#include <array>
#include <optional>
#include <vector>

namespace edgescan::edges {

/// In the plane of the beams: `across` at right angles to the cell's own beam, `away` along it, both in metres from the cell.
struct ProfilePoint {
    std::size_t cell = 0;
    int side = 0; ///< -1 or 1: before or behind the cell; 0: the cell itself
    double acrossM = 0.0;
    double awayM = 0.0;
};
struct ProfileLine {
    double fromAcrossM = 0.0, fromAwayM = 0.0, toAcrossM = 0.0, toAwayM = 0.0;
    int points = 0; ///< number of points that it was fitted to
};
struct EdgeProfile {
    Along along = Along::Beams;
    std::vector<ProfilePoint> points;                ///< in order; cells without a range are left out
    std::array<std::optional<ProfileLine>, 2> sides; ///< before and behind the cell; empty if a side has fewer than 3 points
};

/// The profile with up to `reach` cells on either side. Each straight line is fitted to the 6 nearest points of a side, without those
/// beyond a jump between them, with the smallest sum of squared distances from the line. Empty if the cell has no range.
[[nodiscard]] EdgeProfile edgeProfile(const Scan& scan, std::size_t k, Along along, int reach = 12);

/// The depths that a picture of the profile shows: of the cell and the 6 nearest points of each side, without one or two points of them
/// that are far from all others. Of the profile without points: 0 and 0.
struct DepthsShown {
    double leastM = 0.0, mostM = 0.0;
};
[[nodiscard]] DepthsShown depthsShown(const EdgeProfile& profile);

} // namespace edgescan::edges
