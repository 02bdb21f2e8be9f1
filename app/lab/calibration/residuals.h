// The distance between the two views of a surface, and the effect of each assembly error on it (docs/reference/calibration.md,
// "Residuals").
#pragma once

#include "app/lab/calibration/surface_fits.h"
#include "app/lab/calibration/twice_seen.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace edgescan::inspect {

using AssemblyVector = Eigen::Matrix<double, AssemblyErrors::kCount, 1>;
using AssemblyMatrix = Eigen::Matrix<double, AssemblyErrors::kCount, AssemblyErrors::kCount>;

/// One cell compared with the surface that the other view measured.
struct Residual {
    /// distance along the other view's beam; positive: the surface is nearer than the cell's point
    double apartMm = 0;
    double sigmaMm = 1;                            ///< from noise, misfit and angle
    AssemblyVector slope = AssemblyVector::Zero(); ///< derivative of apartMm: mm per mm and mm per degree, in the order of AssemblyErrors
    int line = 0;
    int beam = 0;
    int shares = 0; ///< residuals with the same number have correlated errors: those of a line (spin), those of a tile (sweep)
};

/// A scan prepared for residuals: its angles, its cleaned ranges, its noise. `polar` must outlive it.
struct PreparedSweep {
    const PolarGeometry& polar;
    InverseRange inverse;
    RangeNoise noise;
    std::vector<double> lineSteps, beamSteps; ///< degrees from each line or beam to the next
};
[[nodiscard]] PreparedSweep preparedSweep(const Scan& scan, const PolarGeometry& polar);

/// The residuals of the cells whose place in the other view is on a measured surface; `fits` are those of the sweep.
[[nodiscard]] std::vector<Residual> residualsOf(const PreparedSweep& sweep, SurfaceFits& fits, const std::vector<SeenCell>& cells,
                                                View view, const AssemblyErrors& errors);

} // namespace edgescan::inspect
