// How a laser of a ROS bag was turned: the axis and the angle of each line, from the transforms of its frame or from a joint.
#pragma once

#include "core/robots/bags/bag.h"
#include "core/robots/sweeps/frames.h"
#include "core/scan/grid/placement.h"
#include "core/scan/grid/scan.h"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace edgescan::robots {

inline constexpr double kLeastTurnDeg = 1.0; ///< of a sweep; what turns less is at rest

/// An angle of the axis that turns the laser.
struct TimedAngle {
    std::int64_t ns = 0;
    double deg = 0;
};

struct LaserMotion {
    Axis axis = Axis::Spin;
    bool axisAssumed = false;
    double beamShiftDeg = 0;         ///< is taken off the beam angles: the axis is the beam at 90 degrees (spin) or at 0 degrees (sweep)
    std::vector<TimedAngle> angles;  ///< by time
    double outOfPlaneDeg = 0;        ///< between the axis and the plane of the fan
    double offAxisM = 0;             ///< distance of the laser's origin from the axis
    std::string mover;               ///< the frame that turns, or the joint
    std::string source;              ///< "the transform of the frame laser in base", "the joint tilt"
    StepperMount mount;              ///< how the scan's own frame is mounted on the frame that turns
    std::string baseFrame;           ///< frame in which that one turns; empty: not known
    RigidTransform base;             ///< the axis base in it
    std::size_t damagedMessages = 0; ///< of joints
};

/// The angle between two of them in a straight line, before the first and after the last theirs; rate in degrees per second there.
struct AngleAt {
    double deg = 0, degPerS = 0;
    bool inside = true; ///< false: before the first or after the last
};
[[nodiscard]] AngleAt angleAt(const std::vector<TimedAngle>& angles, std::int64_t ns);

/// LaserMotion::beamShiftDeg where the axis is not known. Lasers on ROS look along 0 degrees, and the scan's own viewing direction is 90.
[[nodiscard]] double forwardShiftDeg(double fanMiddleDeg);

/// The lowest link above `frame` that turned between two times, about an axis in the plane of the fan: a spin if it is nearer to the middle
/// of the fan, else a sweep. Error: none turned, or about an axis across the fan, or about several.
Result<LaserMotion> motionByFrames(const FrameTree& tree, const std::string& frame, double fanMiddleDeg, std::int64_t fromNs,
                                   std::int64_t toNs, const std::string& where);

/// The angle of a later pose of the frame that turns, on from the last one of `motion`.
[[nodiscard]] double laterAngleDeg(const LaserMotion& motion, const TimedPose& pose);

/// The angles of the joints in messages of sensor_msgs/JointState, by name.
using JointAngles = std::map<std::string, std::vector<TimedAngle>>;
void addJoints(JointAngles& joints, const RosValue& message);

/// The angles of a joint; the axis is only assumed, by its name. As motionByJoint().
Result<LaserMotion> motionOfJoints(JointAngles joints, const std::string& joint, const std::string& where);

/// The angles of a joint of sensor_msgs/JointState; the axis is only assumed, by its name. Without a name: of the joint that turned
/// furthest, and of one whose name is a scanner's rather than of others. `goOn`: false cancels.
Result<LaserMotion> motionByJoint(const RosBag& bag, const std::string& joint, std::int64_t fromNs, std::int64_t toNs,
                                  const std::string& where, const std::function<bool()>& goOn);

/// All transforms of the bag; call FrameTree::finish() before it is used. Error: their definition is not understood, or cancelled.
Result<FrameTree> transformsIn(const RosBag& bag, const std::string& where, const std::function<bool()>& goOn);

/// Where no frame of a map is above `frame`, but the bag has geometry_msgs/PoseStamped in one: they become the transforms of the highest
/// frame above it. A warning says that it is a guess. Call it before FrameTree::finish().
void addPoses(FrameTree& tree, const RosBag& bag, const std::string& frame, std::vector<std::string>& warnings);

/// Gives the scan its place where a frame of a map is above the laser: map, mine, utm or world, also behind a namespace. One pose if that
/// frame stayed, else one for each line. Its axes are east, north and up (REP 105); a warning says that it is a guess.
void placeByFrames(Scan& scan, const FrameTree& tree, const LaserMotion& motion, std::vector<std::string>& warnings);

} // namespace edgescan::robots
