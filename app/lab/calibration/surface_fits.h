// Planes in inverse range around the cells of a sweep (docs/reference/calibration.md, "Surfaces").
#pragma once

#include "core/scan/grid/inverse_range.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace edgescan::inspect {

/// u = c . (1, dx, dy) [1/m], dx beams and dy lines from the middle cell.
struct SurfaceFit {
    Eigen::Vector3d c = Eigen::Vector3d::Zero();
    Eigen::Matrix3d inverseNormal = Eigen::Matrix3d::Zero(); ///< of the least squares: x^T inverseNormal x is the leverage at x
    double misfitMm = 0;                                     ///< root mean square distance of the cells from the plane, along the beam
    bool usable = false;                                     ///< enough measured cells, and a misfit below 30 mm + 2 % of the range
};

/// Each fit is computed on its first use and then stored. Not for several threads.
class SurfaceFits {
public:
    /// @param halfWidth of the square of cells, 1 or more. `inverse` must outlive this object.
    SurfaceFits(const InverseRange& inverse, int halfWidth);
    const SurfaceFit& at(int line, int beam);

private:
    const InverseRange& inverse_;
    int halfWidth_;
    std::vector<std::int32_t> place_; ///< per cell: index of fits_, -1 if not computed
    std::vector<SurfaceFit> fits_;
};

} // namespace edgescan::inspect
