// Frames and their links.
#include "core/robots/sweeps/frames.h"
#include "core/base/translated_text.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <unordered_set>

namespace edgescan::robots {
namespace {

constexpr double kShortestRotation = 1e-6;
constexpr std::size_t kMostFrames = 100'000, kLongestChain = 1000; // a robot has some hundred frames, and some ten above its laser

RigidTransform rigid(const TimedPose& pose) { return {pose.rotation.toRotationMatrix(), pose.translationM}; }

} // namespace

std::optional<TimedPose> poseIn(const RosValue& message, const std::string& position, const std::string& rotation) {
    const auto number = [&](const std::string& path) { return message.number(path).value_or(std::numeric_limits<double>::quiet_NaN()); };
    const Eigen::Quaterniond turn(number(rotation + ".w"), number(rotation + ".x"), number(rotation + ".y"), number(rotation + ".z"));
    const Eigen::Vector3d at(number(position + ".x"), number(position + ".y"), number(position + ".z"));
    const auto ns = stampNs(message, "header.stamp");
    if (!ns || !at.allFinite() || !(turn.norm() > kShortestRotation) || !std::isfinite(turn.norm())) return std::nullopt;
    return TimedPose{*ns, turn.normalized(), at};
}

std::string frameNameOf(std::string_view name) {
    while (name.starts_with('/')) name.remove_prefix(1);
    return std::string(name);
}

std::vector<NamedPose> posesIn(const RosValue& tfMessage, std::size_t& unusable) {
    std::vector<NamedPose> poses;
    const RosValue* transforms = tfMessage.at("transforms");
    for (std::size_t n = 0; transforms != nullptr && n < transforms->inside.size(); ++n) {
        const RosValue& transform = transforms->inside[n];
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

void FrameTree::add(const RosValue& tfMessage) {
    for (const NamedPose& found : posesIn(tfMessage, unusable_)) add(found);
}

void FrameTree::add(const NamedPose& found) {
    if (poses_ >= mostPoses_ || (links_.size() >= kMostFrames && !links_.contains(found.child))) {
        ++tooMany_;
        return;
    }
    FrameLink& link = links_[found.child];
    if (link.parent.empty()) link.parent = found.parent;
    if (link.parent != found.parent) {
        ++moved_;
        return;
    }
    link.poses.push_back(found.pose);
    ++poses_;
}

void FrameTree::forgetBefore(std::int64_t ns) {
    for (auto& [child, link] : links_) {
        if (link.poses.size() < 2) continue;
        const auto old = [&](const TimedPose& pose) { return pose.ns < ns; };
        const auto kept = std::remove_if(link.poses.begin(), std::prev(link.poses.end()), old);
        poses_ -= static_cast<std::size_t>(std::prev(link.poses.end()) - kept);
        link.poses.erase(kept, std::prev(link.poses.end()));
    }
}

void FrameTree::sortPoses() {
    poses_ = 0;
    for (auto& [child, link] : links_) {
        std::ranges::stable_sort(link.poses, {}, &TimedPose::ns);
        const auto again =
            std::unique(link.poses.begin(), link.poses.end(), [](const TimedPose& a, const TimedPose& b) { return a.ns == b.ns; });
        link.poses.erase(again, link.poses.end());
        poses_ += link.poses.size();
    }
}

void FrameTree::warnOfCount(std::size_t count, const char* what) {
    if (count > 0) warnings_.push_back(std::to_string(count) + what);
}

void FrameTree::finish() {
    sortPoses();
    warnOfCount(damaged_, " messages of transforms are damaged and were left out.");
    warnOfCount(unusable_, " transforms of the bag have no rotation, no name or no finite numbers and were left out.");
    warnOfCount(moved_, " transforms name another parent for their frame than the first one and were left out.");
    warnOfCount(tooMany_, " transforms of the bag are of more frames than any robot has and were left out.");
    warnOfWays();
}

/// Goes each link once: a way up ends at a frame whose own way is known.
void FrameTree::warnOfWays() {
    std::unordered_map<std::string_view, std::size_t> above; // by frame; 0: on the way now
    bool loops = false, isLong = false;
    for (auto start = links_.begin(); start != links_.end() && !loops; ++start) {
        std::vector<std::string_view> way;
        auto at = start;
        for (; at != links_.end() && above.try_emplace(at->first, 0).second; at = links_.find(at->second.parent)) way.push_back(at->first);
        std::size_t length = at != links_.end() ? above[at->first] : 0;
        loops = at != links_.end() && length == 0;
        if (loops) warnings_.push_back(withValues("The transforms of the bag form a loop at the frame %1.", {start->first}));
        for (; !way.empty(); way.pop_back()) above[way.back()] = ++length;
        isLong = isLong || length >= kLongestChain;
    }
    if (isLong)
        warnings_.push_back(
            withValues("The transforms of the bag form a chain of more than %1 frames: those above are not used.", {kLongestChain}));
}

std::vector<std::string> FrameTree::chain(const std::string& frame) const {
    std::vector<std::string> up{frame};
    std::unordered_set<std::string_view> passed{frame};
    for (auto at = links_.find(frame); at != links_.end() && up.size() < kLongestChain; at = links_.find(up.back())) {
        if (!passed.insert(at->second.parent).second) break;
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

std::optional<RigidTransform> FrameTree::inFrame(const std::vector<std::string>& up, const std::string& above, std::int64_t ns) const {
    RigidTransform all;
    for (const std::string& at : up) {
        if (at == above) return all;
        const auto step = inParent(at, ns);
        if (!step) return std::nullopt;
        all = *step * all;
    }
    return std::nullopt;
}

} // namespace edgescan::robots
