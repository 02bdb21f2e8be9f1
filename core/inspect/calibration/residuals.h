// How far the two views of a surface lie apart, and what each error of the assembly does to that (docs/calibration.md, "Residuals").
#pragma once

#include "core/inspect/calibration/surface_fits.h"
#include "core/inspect/calibration/twice_seen.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace edgescan {

using AssemblyVector = Eigen::Matrix<double, AssemblyErrors::kCount, 1>;
using AssemblyMatrix = Eigen::Matrix<double, AssemblyErrors::kCount, AssemblyErrors::kCount>;

/// One cell against the surface that the other view measured.
struct Residual {
    double apartMm = 0;                            ///< along the other view's beam; positive: the surface lies nearer than the cell's point
    double sigmaMm = 1;                            ///< of noise, misfit and angle
    AssemblyVector slope = AssemblyVector::Zero(); ///< of apartMm: mm per mm and per degree, in the order of AssemblyErrors
    int line = 0;
    int beam = 0;
    int shares = 0; ///< residuals of the same number err alike: those of a line (spin), those of a place (sweep)
};

/// A scan made ready: its angles, its ranges cleaned, its noise. `polar` must outlive it.
struct TurnedSweep {
    const PolarGeometry& polar;
    InverseRange inverse;
    RangeNoise noise;
    std::vector<double> lineSteps, beamSteps; ///< degrees from each line or beam to the next
};
[[nodiscard]] TurnedSweep turnedSweep(const Scan& scan, const PolarGeometry& polar);

/// Of the cells whose other view falls on a surface that was measured; `fits` are those of the sweep.
[[nodiscard]] std::vector<Residual> residualsOf(const TurnedSweep& sweep, SurfaceFits& fits, const std::vector<SeenCell>& cells, View view,
                                                const AssemblyErrors& errors);

} // namespace edgescan
