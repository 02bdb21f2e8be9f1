// How far two surfaces lie apart, as their noise has it.
#pragma once

#include "core/inspect/registration/placed_scan.h"

#include <optional>

namespace edgescan {

/// Median distance, metres, of `points` from the surface of `fixed` where its sensor saw it: the plane through the 24 cells that it
/// measured closest to the point's direction. Cells are chosen by direction alone: those closest in space are those whose noise is like the
/// point's, and planes that are chosen for their flatness are those whose noise happens to be small. Points farther than `reachM` off the
/// surface, or where it is much rougher than elsewhere, do not count; empty where fewer than 200 do.
[[nodiscard]] std::optional<double> surfacesApartM(const PlacedScan& fixed, const std::vector<Eigen::Vector3d>& points, double reachM);

} // namespace edgescan
