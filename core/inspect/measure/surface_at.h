// The plane of the surface at a cell, as far as the surface goes on smoothly there.
#pragma once

#include "core/inspect/measure/resolution.h"
#include "core/scan/grid/inverse_range.h"

#include <Eigen/Core>

#include <cstddef>
#include <optional>

namespace edgescan {

struct SurfaceAtCell {
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ(); ///< unit, on the side of the sensor, frame of the scan
    double offBeamDeg = 0.0;                           ///< between the normal and the way back to the sensor: 0 = faces it, 90 = grazing
    double sigmaDeg = 0.0;                             ///< one standard deviation of the normal, in its least certain direction
    double reliefM = 0.0;                              ///< root mean square of what lies off the plane, along the beams
    int cells = 0;                                     ///< that lie on it
};

/// A plane through the cells round `k` that lie on one: of five by five cells with `k` among them the flattest, widened to three times what
/// is resolved. Least squares in inverse range, in which the noise of the ranges is the only error. Empty where too few cells lie on a
/// plane, or the plane is seen edge on. `sigmaM`: noise of a range.
[[nodiscard]] std::optional<SurfaceAtCell> surfaceAt(const Scan& scan, const CartesianTables& tables, std::size_t k, double sigmaM);

/// How a plane lies to the horizon, as geologists say it.
struct Dip {
    double dipDeg = 0.0;       ///< 0 level .. 90 upright
    double directionDeg = 0.0; ///< clockwise from grid north to the way it falls; 0 .. 360; means nothing where the dip is 0
};
/// `normalEnu`: east, north, up; either side of the plane.
[[nodiscard]] Dip dipOf(const Eigen::Vector3d& normalEnu);

} // namespace edgescan
