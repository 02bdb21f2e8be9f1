// How far nothing is seen to stand under a point.
#pragma once

#include "core/rocks/segmentation/segments.h"
#include "core/scan/grid/cartesian.h"

namespace edgescan {

/// Metres of free space down from the point (frame of the scan, seen from its sensor near cell `k`), in steps of 5 cm: each step must lie
/// on a beam that was measured to go on behind it. What sent nothing back is never free, so this is the least that is free. `tables`: of
/// the scan.
[[nodiscard]] double freeBelowM(const RockInputs& inputs, const CartesianTables& tables, const Eigen::Vector3d& pointM, std::size_t k,
                                const Eigen::Vector3d& up);

} // namespace edgescan
