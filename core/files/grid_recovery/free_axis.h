// The scan lines of a list that was turned and moved: the axis that they turn about, and where the mirror is, found from the points in
// their order.
#pragma once

#include "core/base/result.h"
#include "core/files/grid_recovery/recover_grid.h"

#include <Eigen/Core>

#include <vector>

namespace edgescan::files {

/// p_file = S turn^T Rot(axis, line angle) (tilt p_fan + lever) + place, S = scale for the first two coordinates: the chain of
/// docs/reference/coordinates.md with one pose. Numbers of the file.
struct FreeAxis {
    Axis axis = Axis::Spin;
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity(); ///< axes of the file -> axes of the scanner
    Eigen::Vector3d place = Eigen::Vector3d::Zero();    ///< a point of the axis: the foot of the mirror's centre
    Eigen::Matrix3d tilt = Eigen::Matrix3d::Identity(); ///< the fan on the stepper
    Eigen::Vector3d lever = Eigen::Vector3d::Zero();    ///< the mirror's centre on the stepper
    double scale = 1.0;                                 ///< of a mine grid
    double fanDeg = 0.0;                                ///< from the first to the last beam, where scanners have such a fan; 0 = none
    std::vector<Eigen::Vector3d> points;                ///< the list in the scanner's frame, as if tilt and lever were nothing
    Precision precision;                                ///< of these points: as that of the list
    double misfit = 0.0;                                ///< root mean square distance of the points from their planes and rays
};

/// Error: cancelled, the list has no lines in order, or they turn about no common axis. `list.axis` names the mounting where it is known;
/// `list.rowLength` is not used.
Result<FreeAxis> findFreeAxis(const PointList& list);

} // namespace edgescan::files
