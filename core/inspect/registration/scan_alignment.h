// Corrects approximate poses: registers the surfaces of two scans by point-to-plane distances (Chen and Medioni 1992).
#pragma once

#include "core/base/result.h"
#include "core/inspect/registration/placed_scan.h"

namespace edgescan::inspect {

struct ScanAlignment {
    RigidTransform correction;                     ///< to be applied to the points of `moved` in the common frame
    double residualBeforeM = 0.0, residualM = 0.0; ///< surfaceDistanceM() between `moved` and `fixed`; at least the noise of both
    std::size_t pairs = 0;                         ///< points with a neighbour within reach
};

inline constexpr double kMostResidualM = 0.03; ///< with a larger residual the surfaces of two scans do not fit

/// Error: too few points are within `reachM` of each other, or they do not determine all six degrees of freedom.
Result<ScanAlignment> alignScans(const PlacedScan& fixed, const PlacedScan& moved, double reachM);

/// The scan after the correction.
[[nodiscard]] PlacedScan corrected(PlacedScan placed, const RigidTransform& correction);

} // namespace edgescan::inspect
