// ROS topics of an MCAP recording.
#include "core/base/checked_size.h"
#include "core/containers/mcap/reader.h"
#include "core/containers/ros/bag.h"

#include <map>
#include <optional>

namespace edgescan::containers {
namespace {

/// The topic that a channel describes; nothing: it is not one of ROS, or its definition is in another language.
std::optional<RosTopic> topicOf(const McapContent& content, const McapChannel& channel) {
    const bool cdr = channel.encoding == "cdr";
    if (!cdr && channel.encoding != "ros1") return std::nullopt;
    const auto schema = content.schemas.find(channel.schema);
    if (schema == content.schemas.end()) return std::nullopt;
    RosTopic topic{channel.topic, rosTypeName(schema->second.name), {}, cdr ? RosEncoding::Cdr : RosEncoding::Ros1, false};
    if (schema->second.encoding == (cdr ? "ros2msg" : "ros1msg") && !schema->second.text.empty()) {
        topic.definition = schema->second.text;
    } else {
        topic.definition = commonRosDefinition(topic.type);
        topic.assumed = true;
    }
    return topic;
}

} // namespace

bool hasRosTopics(const McapContent& content) {
    for (const auto& [id, channel] : content.channels) {
        if (topicOf(content, channel)) return true;
    }
    return false;
}

RosBag rosBagOf(const McapContent& content, const std::string& where) {
    RosBag bag;
    bag.kind = "ROS 2 bag (MCAP)";
    std::map<std::uint16_t, std::uint32_t> topics;
    for (const auto& [id, channel] : content.channels) {
        auto topic = topicOf(content, channel);
        if (!topic) continue;
        topics[id] = static_cast<std::uint32_t>(bag.topics.size());
        bag.topics.push_back(std::move(*topic));
    }
    std::uint64_t packed = 0;
    for (const McapMessage& message : content.messages) packed += message.payload.size();
    bag.mayUnpack = mostUnpackedBytes(packed);
    std::size_t bad = 0;
    for (const McapMessage& message : content.messages) {
        const auto topic = topics.find(message.channel);
        if (topic == topics.end()) continue;
        const auto bytes = plainMessage(bag, message.payload, where);
        if (bytes)
            bag.messages.push_back({topic->second, static_cast<std::int64_t>(message.logNs), *bytes});
        else
            ++bad;
    }
    bag.warnings = content.warnings;
    if (bad > 0) bag.warnings.push_back(std::to_string(bad) + " messages are compressed and damaged and were left out.");
    return bag;
}

} // namespace edgescan::containers
