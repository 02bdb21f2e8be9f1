// The steps of the chain of frames.
#include "core/scan/georef/chain.h"
#include "core/base/translated_text.h"

#include "core/base/number_text.h"
#include "core/scan/georef/rotations.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace edgescan {

using Eigen::Matrix3d;
using Eigen::Vector3d;

RigidTransform moverFromSensor(const Vector3d& mountRpyDeg, const Vector3d& mountM) { return {rotationRpyDeg(mountRpyDeg), mountM}; }

Result<PitchRoll> pitchRollOfElevations(double tiltXDeg, double tiltYDeg) {
    const double sine = std::sin(radians(tiltYDeg)) / std::cos(radians(tiltXDeg));
    if (!(std::abs(tiltXDeg) < 90.0) || !(std::abs(sine) <= 1.0)) {
        return Error{withValues("the inclinometer's two axes cannot be raised by %1 and %2 degrees at once",
                                {significantText(tiltXDeg, 6), significantText(tiltYDeg, 6)}),
                     "", "check whether it reads pitch and roll instead of the elevations of its axes"};
    }
    return PitchRoll{tiltXDeg, degrees(std::asin(sine))};
}

RigidTransform levelledFromInclinometer(const PitchRoll& head) {
    return {levelling(radians(head.pitchDeg), radians(head.rollDeg)), Vector3d::Zero()};
}

RigidTransform vehicleFromRobot(const Vector3d& boresightRpyDeg, const Vector3d& talinM) {
    const Matrix3d rotation = rotationRpyDeg(boresightRpyDeg) * fluToFrd();
    return {rotation, -(rotation * talinM)};
}

Matrix3d nedFromVehicle(double gridHeadingDeg, double pitchDeg, double rollDeg) {
    return rotationRpy(radians(rollDeg), radians(pitchDeg), radians(gridHeadingDeg));
}

PitchRoll robotTilt(const Matrix3d& nedFromRobot) {
    const Vector3d up = -nedFromRobot.row(2).transpose();
    return {degrees(std::asin(std::clamp(up.x(), -1.0, 1.0))), degrees(std::atan2(up.y(), up.z()))};
}

Matrix3d robotFromLevelled(const PitchRoll& robot, double boomAzimuthDeg) {
    return levelling(radians(robot.pitchDeg), radians(robot.rollDeg)).transpose() * rotationZ(radians(boomAzimuthDeg));
}

Result<double> boomAzimuthOfSlew(const PitchRoll& robot, double slewDeg, double boomElevationDeg) {
    const Matrix3d level = levelling(radians(robot.pitchDeg), radians(robot.rollDeg));
    const Vector3d up = level.row(2).transpose();
    // The height of Rz(slew) Ry(-eps) e_x is along cos eps + across sin eps; eps is the boom's elevation relative to the robot.
    const Vector3d forward = rotationZ(radians(slewDeg)).col(0);
    const double along = up.dot(forward);
    const double across = up.z();
    const double sine = std::sin(radians(boomElevationDeg)) / std::hypot(along, across);
    if (!(std::abs(sine) <= 1.0)) {
        return Error{withValues("a boom slewed by %1 degrees on this robot cannot be raised by %2",
                                {significantText(slewDeg, 6), significantText(boomElevationDeg, 6)}),
                     "", "check the slew angle and the inclinometer"};
    }
    const double eps = std::asin(sine) - std::atan2(along, across);
    const Vector3d heading = level * (forward * std::cos(eps) + Vector3d::UnitZ() * std::sin(eps));
    return degrees(std::atan2(heading.y(), heading.x()));
}

double gridHeadingDeg(double trueHeadingDeg, double convergenceDeg) { return trueHeadingDeg - convergenceDeg; }

Vector3d chooseOrigin(const Vector3d& enhM) {
    return {std::floor(enhM.x() / 100) * 100, std::floor(enhM.y() / 100) * 100, std::floor(enhM.z() / 10) * 10};
}

Vector3d localEnu(const Vector3d& dNed, const Vector3d& talinEnhM, const Vector3d& originEnhM, double gridScale) {
    return (talinEnhM - originEnhM) + Vector3d(gridScale, gridScale, 1.0).cwiseProduct(nedToEnu() * dNed);
}

Result<RigidTransform> localFromAxisBase(const MomentPose& pose, const Vector3d& originEnhM, double gridScale) {
    const Matrix3d nedFromRobot = pose.nedFromVehicle * pose.vehicleFromRobot.rotation;
    const PitchRoll robot = robotTilt(nedFromRobot);
    Result<double> azimuth = pose.boomAzimuthDeg;
    if (pose.slewAboutRobotZ) azimuth = boomAzimuthOfSlew(robot, pose.boomAzimuthDeg, pose.head.pitchDeg);
    if (!azimuth) return azimuth.error();
    const Matrix3d robotFromLevel = robotFromLevelled(robot, *azimuth);
    const RigidTransform level = levelledFromInclinometer(pose.head);
    const Vector3d head = pose.headInRobotM + robotFromLevel * (level.rotation * pose.armM);
    const RigidTransform robotFromBase = RigidTransform{robotFromLevel, head} * level * pose.inclinometerFromAxisBase;
    const RigidTransform ned = RigidTransform{pose.nedFromVehicle, Vector3d::Zero()} * pose.vehicleFromRobot * robotFromBase;
    return RigidTransform{nedToEnu() * ned.rotation, localEnu(ned.translationM, pose.talinEnhM, originEnhM, gridScale)};
}

} // namespace edgescan
