// The plane of the surface at a cell, fitted as far as the surface is smooth.
#pragma once

#include "core/inspect/measure/resolution.h"
#include "core/scan/grid/inverse_range.h"

#include <Eigen/Core>

#include <cstddef>
#include <optional>

namespace edgescan::inspect {

struct SurfaceAtCell {
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ(); ///< unit vector, on the side of the sensor, frame of the scan
    /// between the normal and the direction to the sensor: 0 = faces the sensor, 90 = grazing
    double offBeamDeg = 0.0;
    double sigmaDeg = 0.0; ///< one standard deviation of the normal, in its least certain direction
    double reliefM = 0.0;  ///< root mean square distance from the plane, along the beams
    int cells = 0;         ///< number of cells on the plane
};

/// Fits a plane to the cells around `k`: the flattest of the patches of five by five cells that contain `k`, then widened to three times
/// the resolution. Least squares in inverse range, in which only the noise of the ranges causes errors. Empty if too few cells are on a
/// plane, or if the plane is seen edge on. `sigmaM`: noise of a range.
[[nodiscard]] std::optional<SurfaceAtCell> surfaceAt(const Scan& scan, const CartesianTables& tables, std::size_t k, double sigmaM);

/// The dip of a plane relative to the horizon, as in geology.
struct Dip {
    double dipDeg = 0.0;       ///< 0 horizontal .. 90 vertical
    double directionDeg = 0.0; ///< clockwise from grid north to the direction of steepest descent; 0 .. 360; meaningless if the dip is 0
};
/// `normalEnu`: east, north, up; either side of the plane.
[[nodiscard]] Dip dipOf(const Eigen::Vector3d& normalEnu);

} // namespace edgescan::inspect
