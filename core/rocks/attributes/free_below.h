// The visible free height under a point.
#pragma once

#include "core/rocks/segmentation/segments.h"
#include "core/scan/grid/cartesian.h"

namespace edgescan::rocks {

/// Metres of free space below the point (frame of the scan, seen from its sensor near cell `k`), in steps of 5 cm. A step is free if a beam
/// passes through it and was measured to end behind it. Cells without a return do not count as free, so the true height may be larger.
/// `tables`: of the scan.
[[nodiscard]] double freeHeightM(const Inputs& inputs, const CartesianTables& tables, const Eigen::Vector3d& pointM, std::size_t k,
                                 const Eigen::Vector3d& up);

} // namespace edgescan::rocks
