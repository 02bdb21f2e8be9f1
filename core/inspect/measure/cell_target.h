// The values on the card of a picked cell (docs/guide/measure.md).
#pragma once

#include "core/edges/explain/cell_values.h"
#include "core/edges/pipeline/detection.h"
#include "core/inspect/measure/resolution.h"
#include "core/scan/grid/inverse_range.h"
#include "core/scan/grid/scan.h"

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

/// The boom is that of the moment when the cell's line was measured; it may have moved since.
struct BoomAtCell {
    double distanceM = 0.0; ///< to the nearest point of the straight line from pivot to head; the thickness of the boom is not subtracted
    /// 0..90 between the surface's normal and the boom: 0 = the boom meets the surface at a right angle; empty without a normal
    std::optional<double> angleDeg;
};

/// Empty if the scan has no placement with a boom. `k` must be a valid cell; `normal`: of its surface, frame of the scan.
[[nodiscard]] std::optional<BoomAtCell> boomAt(const Scan& scan, std::size_t k, const std::optional<Eigen::Vector3d>& normal);

/// The number after ± is two standard deviations: 95 of 100 readings are within it.
inline constexpr double kReportedSigmas = 2.0;

struct CellTarget {
    edges::Probe probe;
    double distanceM = 0.0;               ///< m, from the scanner along the beam; meaningless if the cell is not valid
    double toleranceM = 0.0;              ///< m, of the distance: two standard deviations of this scan's noise; 0: unknown
    std::optional<Resolution> resolution; ///< empty if the cell is not valid
    std::optional<SurfaceAtCell> surface; ///< empty if a plane does not fit
    std::optional<Dip> dip;               ///< of the surface, relative to the horizon of the mine; empty without a placement
    std::optional<BoomAtCell> boom;       ///< empty if the placement has no boom
    /// Of the edge, 1 = at the threshold; of a cell that is not an edge as Why reports it. Empty if the method does not measure the
    /// surface.
    std::optional<double> strength;
};

/// The noise of the scan: from the detection, or measured now, which costs about as much as opening the scan.
[[nodiscard]] RangeNoise noiseOf(const edges::Detection& detection);

/// `k` must be a cell of the detection's scan; `noise`: noiseOf() the detection.
[[nodiscard]] CellTarget targetAt(const edges::Detection& detection, const RangeNoise& noise, std::size_t k);

} // namespace edgescan::inspect
