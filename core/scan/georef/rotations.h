// The rotations of docs/reference/coordinates.md, "The chain of frames": right-handed, column vectors, angles in radians unless a name says
// degrees.
#pragma once

#include "core/base/angles.h"

#include <Eigen/Core>

namespace edgescan {

[[nodiscard]] Eigen::Matrix3d rotationX(double angle);
[[nodiscard]] Eigen::Matrix3d rotationY(double angle);
[[nodiscard]] Eigen::Matrix3d rotationZ(double angle);

/// Rz(yaw) Ry(pitch) Rx(roll).
[[nodiscard]] Eigen::Matrix3d rotationRpy(double roll, double pitch, double yaw);
/// The same from degrees in the order roll, pitch, yaw.
[[nodiscard]] Eigen::Matrix3d rotationRpyDeg(const Eigen::Vector3d& rpyDeg);

/// Right-handed about `axis`, which need not have length 1 (Rodrigues).
[[nodiscard]] Eigen::Matrix3d rotationAbout(const Eigen::Vector3d& axis, double angle);

/// Lev(pitch, roll): forward-left-up body -> level frame of the same heading; pitch nose up, roll right side down.
[[nodiscard]] Eigen::Matrix3d levelling(double pitch, double roll);

/// forward-left-up <-> forward-right-down.
[[nodiscard]] Eigen::Matrix3d fluToFrd();
/// north-east-down <-> east-north-up.
[[nodiscard]] Eigen::Matrix3d nedToEnu();

/// Greatest deviation of R R^T from the identity and of det R from 1.
[[nodiscard]] double rotationError(const Eigen::Matrix3d& rotation);

} // namespace edgescan
