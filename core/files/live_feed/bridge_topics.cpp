// Chooses by type and name.
#include "core/files/live_feed/bridge_topics.h"

#include "core/containers/ros/definition.h"

#include <algorithm>

namespace edgescan::files {
namespace {

using scanner::BridgeChannelPtr;

bool isLaser(const std::string& type) { return type == "sensor_msgs/LaserScan" || type == "sensor_msgs/MultiEchoLaserScan"; }
bool givesAngles(const std::string& type) {
    return type == "tf2_msgs/TFMessage" || type == "tf/tfMessage" || type == "sensor_msgs/JointState";
}

std::string namesOf(const std::vector<BridgeChannelPtr>& channels) {
    constexpr std::size_t kLongest = 300;
    std::string names;
    for (const BridgeChannelPtr& channel : channels) {
        if (names.size() > kLongest) return names + " and others";
        names += (names.empty() ? "" : ", ") + channel->topic;
    }
    return names;
}

} // namespace

Result<scanner::BridgeChoice> chooseTopics(const std::vector<BridgeChannelPtr>& offered, const std::string& topic,
                                           const std::string& where) {
    scanner::BridgeChoice choice;
    std::vector<BridgeChannelPtr> lasers;
    for (const BridgeChannelPtr& channel : offered) {
        const std::string type = containers::rosTypeName(channel->type);
        const bool readable = channel->encoding == "cdr" || channel->encoding == "ros1";
        if (readable && isLaser(type)) lasers.push_back(channel);
        if (readable && givesAngles(type)) choice.channels.push_back(channel);
    }
    if (lasers.empty())
        return Error{"the bridge offers no topic of a laser (sensor_msgs/LaserScan)" +
                         (offered.empty() ? std::string() : ": " + namesOf(offered)),
                     where, "check that the laser's driver runs"};
    std::ranges::stable_sort(lasers, {}, [](const BridgeChannelPtr& channel) { return channel->topic; });
    const auto taken =
        topic.empty() ? lasers.begin() : std::ranges::find(lasers, topic, [](const auto& channel) { return channel->topic; });
    if (taken == lasers.end())
        return Error{"the bridge offers no topic of a laser called \"" + topic + "\"", where, "choose one of " + namesOf(lasers)};
    choice.lines = *taken;
    choice.channels.push_back(*taken);
    lasers.erase(taken);
    if (topic.empty() && !lasers.empty())
        choice.note = "GUESS: the topic " + choice.lines->topic + " was taken; --topic chooses another: " + namesOf(lasers) + ".";
    return choice;
}

} // namespace edgescan::files
