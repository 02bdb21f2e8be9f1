// The path along a surface from one picked cell to another: like a tape on the surface, straight as seen from the scanner.
#pragma once

#include "core/inspect/measure/resolution.h"
#include "core/scan/grid/inverse_range.h"

#include <cstdint>
#include <optional>

namespace edgescan::inspect {

struct SurfacePath {
    double lengthM = 0.0;
    double toleranceM = 0.0; ///< two standard deviations, plus the lengthening caused by noise
    double straightM = 0.0;  ///< length of the straight line through the air
    int nodes = 0;           ///< number of points of the path: means of cells, at least one resolution apart
    int leaps = 0;           ///< number of jumps and gaps that the path crosses through the air; their length is included
};

/// The path below the straight line of cells from `from` to `to`. Empty if one of them does not exist, is not valid or has no neighbour
/// with a direction.
[[nodiscard]] std::optional<SurfacePath> surfacePath(const Scan& scan, const CartesianTables& tables, const RangeNoise& noise,
                                                     std::uint32_t from, std::uint32_t to);

} // namespace edgescan::inspect
