// Finds the grid of a table's points by the directions in which they lie from the sensor.
#pragma once

#include "core/files/grid_recovery/free_axis.h"
#include "core/files/point_tables/point_table.h"

#include <vector>

namespace edgescan::files {

struct FoundGrid {
    Result<RecoveredGrid> grid;
    bool inFrameOfFile = false;         ///< the lines turn about an axis of the file's own frame, else about any axis
    std::optional<FreeAxis> moved = {}; ///< how the points are to be taken into the scanner's frame first, which then is the file's
    [[nodiscard]] bool cancelled() const { return !grid && grid.error().what == "cancelled"; }
};

/// `organised`: the points come in rows of `table.width`. `named`: the file gives each point its line and beam, so a grid of another shape
/// is wrong.
[[nodiscard]] FoundGrid findGrid(const PointTable& table, const Source& source, bool organised, bool named);

/// The grid of points that were turned and moved as a whole, as a mine grid does it: their lines turn about any axis anywhere.
[[nodiscard]] FoundGrid findMovedGrid(const PointTable& table, const Source& source, bool organised, bool named);

/// As findGrid() for points with line and beam. If the rows do not make fans about one axis but the columns do, the lines and beams of
/// `table` and of `behind` are exchanged. `fromAfar`: as findMovedGrid() instead, because the points were not measured from the origin.
[[nodiscard]] FoundGrid findGridEitherWay(PointTable& table, const Source& source, std::vector<AttachedPoint>& behind, bool fromAfar);

/// As findGrid() without a turn of the frame.
[[nodiscard]] FoundGrid findGridAboutAxis(const PointTable& table, const Source& source, bool organised, bool named);

/// The grid of an organised cloud whose rows make no fans: its rows as beams, its counts of rows and columns exchanged, or both. Changes
/// the order of the points and says so in a remark. Empty, with the table as before: no order makes fans of all points.
[[nodiscard]] std::optional<FoundGrid> findGridInOtherOrder(PointTable& table, const Source& source, bool fromAfar);

} // namespace edgescan::files
