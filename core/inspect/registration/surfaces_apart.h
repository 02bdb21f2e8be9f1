// The distance between two surfaces, corrected for bias by noise.
#pragma once

#include "core/inspect/registration/placed_scan.h"

#include <optional>

namespace edgescan::inspect {

/// Median distance, metres, of `points` from the surface of `fixed` as its sensor saw it: from the plane through the 24 cells measured
/// closest to the point's direction. Cells are chosen by direction only, because the cells closest in space are those whose noise happens
/// to agree with the point's, and planes chosen for their flatness are those whose noise happens to be small. Points farther than `reachM`
/// from the surface, and points where the surface is much rougher than elsewhere, do not count. Empty if fewer than 200 points count.
[[nodiscard]] std::optional<double> surfaceDistanceM(const PlacedScan& fixed, const std::vector<Eigen::Vector3d>& points, double reachM);

} // namespace edgescan::inspect
