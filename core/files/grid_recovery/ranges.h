// Ranges of whole millimetres behind coordinates that were rounded: once the direction of a beam is known, few ranges along it give just
// these coordinates.
#pragma once

#include "core/files/grid_recovery/recover_grid.h"

#include <vector>

namespace edgescan::files {

/// Points along known directions.
struct DirectedPoints {
    std::vector<Eigen::Vector3d> pointMm;
    std::vector<Eigen::Vector3d> direction; ///< unit vectors, one per point
    Precision precision;                    ///< of the coordinates, mm
};

/// The whole millimetres that the points were computed from, one per point; where a point allows none its own range. Empty unless nearly
/// all points allow one, and clearly more of them than would by chance.
[[nodiscard]] std::vector<float> wholeRangesMm(const DirectedPoints& points);

} // namespace edgescan::files
