// Chooses by type and name.
#include "core/robots/live/bridge_topics.h"
#include "core/base/translated_text.h"

#include "core/robots/bags/definition.h"
#include "core/robots/sweeps/bag_topics.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace edgescan::robots {
namespace {

/// The name of a laser that a motor turns often says so; which one turns is known only when its lines come.
bool namesATurn(const std::string& topic) {
    constexpr std::array<std::string_view, 6> kWords{"tilt", "nod", "spin", "turn", "rotat", "sweep"};
    return std::ranges::any_of(kWords, [&](std::string_view word) { return topic.find(word) != std::string::npos; });
}

std::string namesOf(const std::vector<BridgeChannelPtr>& channels) {
    constexpr std::size_t kLongest = 300;
    std::string names;
    for (const BridgeChannelPtr& channel : channels) {
        if (names.size() > kLongest) return withValues("%1 and others", {names});
        names += (names.empty() ? "" : ", ") + channel->topic;
    }
    return names;
}

} // namespace

bool isCloud(const BridgeChannel& channel) { return givenBy(rosTypeName(channel.type)) == TopicGives::Clouds; }

Result<BridgeChoice> chooseTopics(const std::vector<BridgeChannelPtr>& offered, const std::string& topic, const std::string& where) {
    BridgeChoice choice;
    std::vector<BridgeChannelPtr> lasers, clouds;
    for (const BridgeChannelPtr& channel : offered) {
        const std::string type = rosTypeName(channel->type);
        const bool readable = channel->encoding == "cdr" || channel->encoding == "ros1";
        if (readable && givenBy(type) == TopicGives::Lines) lasers.push_back(channel);
        if (readable && givenBy(type) == TopicGives::Clouds) clouds.push_back(channel);
        if (readable && givesAngles(type)) choice.channels.push_back(channel);
    }
    const auto byName = [](const BridgeChannelPtr& channel) { return std::pair(!namesATurn(channel->topic), channel->topic); };
    std::ranges::stable_sort(lasers, {}, byName);
    std::ranges::stable_sort(clouds, {}, byName);
    lasers.insert(lasers.end(), clouds.begin(), clouds.end());
    if (lasers.empty())
        return Error{withValues("the bridge offers no topic of a laser (sensor_msgs/LaserScan or PointCloud2)%1",
                                {offered.empty() ? std::string() : ": " + namesOf(offered)}),
                     where, "check that the laser's driver runs"};
    const auto taken =
        topic.empty() ? lasers.begin() : std::ranges::find(lasers, topic, [](const auto& channel) { return channel->topic; });
    if (taken == lasers.end())
        return Error{withValues("the bridge offers no topic of a laser called \"%1\"", {topic}), where,
                     withValues("choose one of %1", {namesOf(lasers)})};
    choice.lines = *taken;
    if (isCloud(**taken)) choice.channels.clear(); // its points need no angles
    choice.channels.push_back(*taken);
    lasers.erase(taken);
    if (topic.empty() && !lasers.empty())
        choice.note = withValues("GUESS: the topic %1 was taken; --topic chooses another: %2.", {choice.lines->topic, namesOf(lasers)});
    return choice;
}

} // namespace edgescan::robots
