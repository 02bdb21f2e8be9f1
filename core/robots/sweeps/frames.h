// The frames of a ROS bag: which frame is fixed to which, where it was at what time (tf2_msgs/TFMessage, REP 105).
#pragma once

#include "core/robots/bags/message.h"
#include "core/scan/grid/placement.h"

#include <Eigen/Geometry>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace edgescan::robots {

/// "/laser" and "laser" are one frame.
[[nodiscard]] std::string frameNameOf(std::string_view name);

/// A frame in its parent, metres.
struct TimedPose {
    std::int64_t ns = 0; ///< since 1970 UTC
    Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
    Eigen::Vector3d translationM = Eigen::Vector3d::Zero();
};

/// The pose of a message with a header, its numbers at these paths. Empty: a rotation of length 0, or numbers that are not finite.
[[nodiscard]] std::optional<TimedPose> poseIn(const RosValue& message, const std::string& position, const std::string& rotation);

struct FrameLink {
    std::string parent;
    std::vector<TimedPose> poses; ///< by time; one if the link is static
};

/// The transforms in a message that can be used, with child and parent as frameNameOf().
struct NamedPose {
    std::string child, parent;
    TimedPose pose;
};
/// `unusable` counts those with a rotation of length 0, without names or with numbers that are not finite.
[[nodiscard]] std::vector<NamedPose> posesIn(const RosValue& tfMessage, std::size_t& unusable);

class FrameTree {
public:
    /// `mostPoses`: further ones are counted and left out; for messages that come without end.
    explicit FrameTree(std::size_t mostPoses = SIZE_MAX) : mostPoses_(mostPoses) {}

    /// The transforms of one message. Those that cannot be used are counted and left out.
    void add(const RosValue& tfMessage);
    void add(const NamedPose& pose);
    void addDamagedMessage() { ++damaged_; }
    /// Leaves out poses before `ns`, but not the last one of each link.
    void forgetBefore(std::int64_t ns);
    /// Sorts the poses of each link by time and leaves out repeated ones. All that follows needs it.
    void sortPoses();
    /// sortPoses(), and the warnings about what was left out, loops and long chains. Call it after the last message.
    void finish();

    /// Frames from `frame` up to its root, itself first. A loop ends it, and so does a length that no robot has.
    [[nodiscard]] std::vector<std::string> chain(const std::string& frame) const;
    /// Where a frame is in its parent: between two poses the rotation by slerp, before the first and after the last theirs. Empty: no
    /// parent.
    [[nodiscard]] std::optional<RigidTransform> inParent(const std::string& frame, std::int64_t ns) const;
    /// Where the first frame of a chain() is in another one of it, `above`. Empty: a frame between them has no pose, or that one is not in
    /// it.
    [[nodiscard]] std::optional<RigidTransform> inFrame(const std::vector<std::string>& up, const std::string& above,
                                                        std::int64_t ns) const;
    [[nodiscard]] const FrameLink* link(const std::string& frame) const;
    [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }

private:
    void warnOfCount(std::size_t count, const char* what);
    void warnOfWays();

    std::size_t mostPoses_, poses_ = 0;
    std::map<std::string, FrameLink> links_; // by child
    std::size_t unusable_ = 0, moved_ = 0, damaged_ = 0, tooMany_ = 0;
    std::vector<std::string> warnings_;
};

} // namespace edgescan::robots
