// The way along a surface from one picked cell to another: a tape that lies on it, straight as the scanner sees it.
#pragma once

#include "core/inspect/measure/resolution.h"
#include "core/scan/grid/inverse_range.h"

#include <cstdint>
#include <optional>

namespace edgescan {

struct SurfacePath {
    double lengthM = 0.0;
    double toleranceM = 0.0; ///< two standard deviations, and what the noise makes the tape longer
    double straightM = 0.0;  ///< through the air
    int nodes = 0;           ///< points that the tape is pinned to: means of cells, no nearer to each other than what is resolved
    int leaps = 0;           ///< where it goes through the air, over a jump or a gap: their length is part of it
};

/// Under the straight line of cells from `from` to `to`. Empty where one of them does not exist, is not valid or has no neighbour's
/// direction.
[[nodiscard]] std::optional<SurfacePath> surfacePath(const Scan& scan, const CartesianTables& tables, const RangeNoise& noise,
                                                     std::uint32_t from, std::uint32_t to);

} // namespace edgescan
