// What the cells of a grid hold, by the points of a list in them.
#pragma once

#include "core/files/grid_recovery/unit.h"
#include "core/files/point_tables/point_table.h"

namespace edgescan::files {

inline constexpr double kMetresPerMm = 0.001;

/// Ranges, states and intensities. `ranges`: by point, in the file's own unit. `pointOf`: lines x beams, the point of each cell or
/// RecoveredGrid::kNoPoint. With `useGiven` the ranges in mm that the file holds with its points count, where it has them. Points
/// farther than any scanner reaches become missing returns, and a warning says how many.
void fillCells(Scan& scan, const PointTable& table, const std::vector<double>& ranges, const RangeUnit& unit,
               const Grid<std::uint32_t>& pointOf, bool useGiven);

/// States that a file gives its cells without a point.
void storeStates(Scan& scan, const PointTable& table, const Grid<std::uint32_t>& pointOf);

/// The points themselves in metres, about the table's sensor.
[[nodiscard]] PointGeometry pointGeometry(const PointTable& table, const Grid<std::uint32_t>& pointOf, const RangeUnit& unit);

} // namespace edgescan::files
