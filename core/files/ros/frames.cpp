// Frames and their links.
#include "core/files/ros/frames.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace edgescan::files {
namespace {

constexpr double kShortestRotation = 1e-6;

RigidTransform rigid(const TimedPose& pose) { return {pose.rotation.toRotationMatrix(), pose.translationM}; }

} // namespace

std::optional<TimedPose> poseIn(const containers::RosValue& message, const std::string& position, const std::string& rotation) {
    const auto number = [&](const std::string& path) { return message.number(path).value_or(std::numeric_limits<double>::quiet_NaN()); };
    const Eigen::Quaterniond turn(number(rotation + ".w"), number(rotation + ".x"), number(rotation + ".y"), number(rotation + ".z"));
    const Eigen::Vector3d at(number(position + ".x"), number(position + ".y"), number(position + ".z"));
    const auto ns = containers::stampNs(message, "header.stamp");
    if (!ns || !at.allFinite() || !(turn.norm() > kShortestRotation) || !std::isfinite(turn.norm())) return std::nullopt;
    return TimedPose{*ns, turn.normalized(), at};
}

std::string frameNameOf(std::string_view name) {
    while (name.starts_with('/')) name.remove_prefix(1);
    return std::string(name);
}

std::vector<NamedPose> posesIn(const containers::RosValue& tfMessage, std::size_t& unusable) {
    std::vector<NamedPose> poses;
    const containers::RosValue* transforms = tfMessage.at("transforms");
    for (std::size_t n = 0; transforms != nullptr && n < transforms->inside.size(); ++n) {
        const containers::RosValue& transform = transforms->inside[n];
        NamedPose found{frameNameOf(transform.text("child_frame_id")), frameNameOf(transform.text("header.frame_id")), {}};
        const auto pose = poseIn(transform, "transform.translation", "transform.rotation");
        if (!pose || found.child.empty() || found.parent.empty() || found.child == found.parent) {
            ++unusable;
            continue;
        }
        found.pose = *pose;
        poses.push_back(std::move(found));
    }
    return poses;
}

void FrameTree::add(const containers::RosValue& tfMessage) {
    for (const NamedPose& found : posesIn(tfMessage, unusable_)) add(found);
}

void FrameTree::add(const NamedPose& found) {
    FrameLink& link = links_[found.child];
    if (link.parent.empty()) link.parent = found.parent;
    if (link.parent == found.parent)
        link.poses.push_back(found.pose);
    else
        ++moved_;
}

void FrameTree::forgetBefore(std::int64_t ns) {
    for (auto& [child, link] : links_) {
        if (link.poses.size() < 2) continue;
        const auto old = [&](const TimedPose& pose) { return pose.ns < ns; };
        link.poses.erase(std::remove_if(link.poses.begin(), std::prev(link.poses.end()), old), std::prev(link.poses.end()));
    }
}

void FrameTree::finish() {
    for (auto& [child, link] : links_) {
        std::ranges::stable_sort(link.poses, {}, &TimedPose::ns);
        const auto again =
            std::unique(link.poses.begin(), link.poses.end(), [](const TimedPose& a, const TimedPose& b) { return a.ns == b.ns; });
        link.poses.erase(again, link.poses.end());
    }
    if (unusable_ > 0)
        warnings_.push_back(std::to_string(unusable_) +
                            " transforms of the bag have no rotation, no name or no finite numbers and were left out.");
    if (moved_ > 0)
        warnings_.push_back(std::to_string(moved_) +
                            " transforms name another parent for their frame than the first one and were left out.");
    for (const auto& [child, link] : links_) {
        const std::vector<std::string> up = chain(child);
        if (links_.contains(up.back())) {
            warnings_.push_back("The transforms of the bag form a loop at the frame " + child + ".");
            break;
        }
    }
}

std::vector<std::string> FrameTree::chain(const std::string& frame) const {
    std::vector<std::string> up{frame};
    std::set<std::string> seen{frame};
    for (auto at = links_.find(frame); at != links_.end(); at = links_.find(up.back())) {
        if (!seen.insert(at->second.parent).second) break;
        up.push_back(at->second.parent);
    }
    return up;
}

const FrameLink* FrameTree::link(const std::string& frame) const {
    const auto found = links_.find(frame);
    return found != links_.end() ? &found->second : nullptr;
}

std::optional<RigidTransform> FrameTree::inParent(const std::string& frame, std::int64_t ns) const {
    const FrameLink* of = link(frame);
    if (of == nullptr || of->poses.empty()) return std::nullopt;
    const auto after = std::ranges::upper_bound(of->poses, ns, {}, &TimedPose::ns);
    if (after == of->poses.begin()) return rigid(of->poses.front());
    const TimedPose& before = *std::prev(after);
    if (after == of->poses.end()) return rigid(before);
    const double share = static_cast<double>(ns - before.ns) / static_cast<double>(after->ns - before.ns);
    return rigid(
        {ns, before.rotation.slerp(share, after->rotation), before.translationM + share * (after->translationM - before.translationM)});
}

std::optional<RigidTransform> FrameTree::inFrame(const std::string& frame, const std::string& above, std::int64_t ns) const {
    RigidTransform all;
    for (const std::string& at : chain(frame)) {
        if (at == above) return all;
        const auto step = inParent(at, ns);
        if (!step) return std::nullopt;
        all = *step * all;
    }
    return std::nullopt;
}

} // namespace edgescan::files
