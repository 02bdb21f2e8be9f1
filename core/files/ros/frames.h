// The frames of a ROS bag: which frame is fixed to which, where it was at what time (tf2_msgs/TFMessage, REP 105).
#pragma once

#include "core/containers/ros/message.h"
#include "core/scan/grid/placement.h"

#include <Eigen/Geometry>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace edgescan::files {

/// "/laser" and "laser" are one frame.
[[nodiscard]] std::string frameNameOf(std::string_view name);

/// A frame in its parent, metres.
struct TimedPose {
    std::int64_t ns = 0; ///< since 1970 UTC
    Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
    Eigen::Vector3d translationM = Eigen::Vector3d::Zero();
};

/// The pose of a message with a header, its numbers at these paths. Empty: a rotation of length 0, or numbers that are not finite.
[[nodiscard]] std::optional<TimedPose> poseIn(const containers::RosValue& message, const std::string& position,
                                              const std::string& rotation);

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
[[nodiscard]] std::vector<NamedPose> posesIn(const containers::RosValue& tfMessage, std::size_t& unusable);

class FrameTree {
public:
    /// The transforms of one message. Those that cannot be used are counted and left out.
    void add(const containers::RosValue& tfMessage);
    void add(const NamedPose& pose);
    /// Leaves out poses before `ns`, but not the last one of each link.
    void forgetBefore(std::int64_t ns);
    /// Sorts the poses. Call it after the last message; warnings about loops and other parents follow from it.
    void finish();

    /// Frames from `frame` up to its root, itself first. A loop ends it.
    [[nodiscard]] std::vector<std::string> chain(const std::string& frame) const;
    /// Where a frame is in its parent: between two poses the rotation by slerp, before the first and after the last theirs. Empty: no
    /// parent.
    [[nodiscard]] std::optional<RigidTransform> inParent(const std::string& frame, std::int64_t ns) const;
    /// Where a frame is in one of those above it. Empty: that frame is not above it.
    [[nodiscard]] std::optional<RigidTransform> inFrame(const std::string& frame, const std::string& above, std::int64_t ns) const;
    [[nodiscard]] const FrameLink* link(const std::string& frame) const;
    [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }

private:
    std::map<std::string, FrameLink> links_; // by child
    std::size_t unusable_ = 0, moved_ = 0;
    std::vector<std::string> warnings_;
};

} // namespace edgescan::files
