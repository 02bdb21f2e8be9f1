// Rotation matrices written out: library functions would round differently.
#include "core/scan/georef/rotations.h"

#include "core/base/portable_math.h"

#include <Eigen/Dense>

#include <cmath>

namespace edgescan {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Matrix3d rotationX(double angle) {
    const double c = portable::cos(angle);
    const double s = portable::sin(angle);
    return (Matrix3d() << 1, 0, 0, 0, c, -s, 0, s, c).finished();
}

Matrix3d rotationY(double angle) {
    const double c = portable::cos(angle);
    const double s = portable::sin(angle);
    return (Matrix3d() << c, 0, s, 0, 1, 0, -s, 0, c).finished();
}

Matrix3d rotationZ(double angle) {
    const double c = portable::cos(angle);
    const double s = portable::sin(angle);
    return (Matrix3d() << c, -s, 0, s, c, 0, 0, 0, 1).finished();
}

Matrix3d rotationRpy(double roll, double pitch, double yaw) { return rotationZ(yaw) * rotationY(pitch) * rotationX(roll); }

Matrix3d rotationRpyDeg(const Vector3d& rpyDeg) { return rotationRpy(radians(rpyDeg.x()), radians(rpyDeg.y()), radians(rpyDeg.z())); }

Matrix3d rotationAbout(const Vector3d& axis, double angle) {
    const Vector3d n = axis.normalized();
    const double c = portable::cos(angle);
    const double s = portable::sin(angle);
    Matrix3d cross;
    cross << 0, -n.z(), n.y(), n.z(), 0, -n.x(), -n.y(), n.x(), 0;
    return c * Matrix3d::Identity() + (1 - c) * (n * n.transpose()) + s * cross;
}

Matrix3d levelling(double pitch, double roll) { return rotationY(-pitch) * rotationX(roll); }

Matrix3d fluToFrd() { return Vector3d(1, -1, -1).asDiagonal(); }

Matrix3d nedToEnu() { return (Matrix3d() << 0, 1, 0, 1, 0, 0, 0, 0, -1).finished(); }

double rotationError(const Matrix3d& rotation) {
    const double skew = (rotation * rotation.transpose() - Matrix3d::Identity()).cwiseAbs().maxCoeff();
    return std::max(skew, std::abs(rotation.determinant() - 1.0));
}

} // namespace edgescan
