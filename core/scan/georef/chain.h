// The frames of docs/reference/coordinates.md, "The chain of frames", one function per step: scanner S, mover M, axis base A, inclinometer
// I, levelled L, robot R, TALIN vehicle V, north-east-down, mine grid. Angles in degrees, lengths in metres. T_BA * p_A = p_B.
#pragma once

#include "core/base/result.h"
#include "core/scan/grid/placement.h"

#include <Eigen/Core>

namespace edgescan {

/// T_MS.
[[nodiscard]] RigidTransform moverFromSensor(const Eigen::Vector3d& mountRpyDeg, const Eigen::Vector3d& mountM);

// Step 2: to the inclinometer, then to the levelled frame.

struct PitchRoll {
    double pitchDeg = 0.0; ///< nose up
    double rollDeg = 0.0;  ///< right side down
};
/// Converts the elevations of the X and Y axes, which a two-axis inclinometer measures. Error: such an attitude does not exist.
Result<PitchRoll> pitchRollOfElevations(double tiltXDeg, double tiltYDeg);
/// T_LI.
[[nodiscard]] RigidTransform levelledFromInclinometer(const PitchRoll& head);

// Step 4: robot to TALIN vehicle. It comes before step 3, which needs the robot's own tilt.

/// T_VR. `talinM`: TALIN's position measured in R.
[[nodiscard]] RigidTransform vehicleFromRobot(const Eigen::Vector3d& boresightRpyDeg, const Eigen::Vector3d& talinM);
/// R_NV. The heading is relative to the grid's north, clockwise.
[[nodiscard]] Eigen::Matrix3d nedFromVehicle(double gridHeadingDeg, double pitchDeg, double rollDeg);

// Step 3: to the robot's axes and origin.

/// Pitch and roll of the robot itself from R_NR = R_NV R_VR.
[[nodiscard]] PitchRoll robotTilt(const Eigen::Matrix3d& nedFromRobot);
/// R_RL = Lev(pR, rR)^T Rz(psiB). The levelled frame is level and the robot is not: if the robot's tilt were left out here, it would be
/// applied twice in the next step.
[[nodiscard]] Eigen::Matrix3d robotFromLevelled(const PitchRoll& robot, double boomAzimuthDeg);
/// psiB for a slew angle that is counted about the robot's Z axis instead of the vertical. `boomElevationDeg`: tilt of the head's X axis.
/// Error: with this slew angle the boom cannot have this elevation.
Result<double> boomAzimuthOfSlew(const PitchRoll& robot, double slewDeg, double boomElevationDeg);

// Step 5: to the mine grid.

/// Grid heading = true heading - convergence.
[[nodiscard]] double gridHeadingDeg(double trueHeadingDeg, double convergenceDeg);
/// Easting, northing and height of the local origin: rounded down to 100, 100 and 10 m.
[[nodiscard]] Eigen::Vector3d chooseOrigin(const Eigen::Vector3d& enhM);
/// Metres from the origin: (T - O) + k d, scaled horizontally by k.
[[nodiscard]] Eigen::Vector3d localEnu(const Eigen::Vector3d& dNed, const Eigen::Vector3d& talinEnhM, const Eigen::Vector3d& originEnhM,
                                       double gridScale);

/// All values between the axis base and the mine grid at one moment.
struct MomentPose {
    RigidTransform inclinometerFromAxisBase; ///< T_IA
    PitchRoll head;                          ///< of the inclinometer
    double boomAzimuthDeg = 0.0;             ///< psiB, or the slew angle about the robot's Z axis
    bool slewAboutRobotZ = false;
    Eigen::Vector3d headInRobotM = Eigen::Vector3d::Zero(); ///< position in R of the head, or of the boom's pivot if armM is not zero
    Eigen::Vector3d armM = Eigen::Vector3d::Zero();         ///< from pivot to head, in the axes of I, because it moves with the boom
    RigidTransform vehicleFromRobot;                        ///< T_VR
    Eigen::Matrix3d nedFromVehicle = Eigen::Matrix3d::Identity();
    Eigen::Vector3d talinEnhM = Eigen::Vector3d::Zero();
};

/// A -> metres from the origin, as Placement stores it: the translation is in grid metres, the rotation is proper.
Result<RigidTransform> localFromAxisBase(const MomentPose& pose, const Eigen::Vector3d& originEnhM, double gridScale);

} // namespace edgescan
