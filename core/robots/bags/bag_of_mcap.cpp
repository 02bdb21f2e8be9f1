// ROS topics of an MCAP recording.
#include "core/base/checked_size.h"
#include "core/base/memory.h"
#include "core/base/number_text.h"
#include "core/containers/compression/chunks.h"
#include "core/containers/mcap/reader.h"
#include "core/robots/bags/bag.h"

#include <map>
#include <optional>

namespace edgescan::robots {
namespace {

constexpr std::uint64_t kAskFrom = 1 << 20; // of the machine's memory: less is always there

std::optional<RosTopic> topicOf(const containers::McapContent& content, const containers::McapChannel& channel) {
    const auto schema = content.schemas.find(channel.schema);
    if (schema == content.schemas.end()) return std::nullopt;
    return rosTopic(channel.topic, channel.encoding, schema->second.name, schema->second.encoding, schema->second.text);
}

} // namespace

// Compressed parts of bags.

Result<ByteView> unpackedInto(RosBag& bag, const std::string& compression, ByteView packed, std::uint64_t size, const std::string& where,
                              const std::function<bool()>& goOn) {
    if (size > bag.mayUnpack) return Error{"it promises to unpack to more than a bag of this size holds", where, ""};
    if (size >= kAskFrom) {
        if (auto enough = checkMemory(size, where); !enough) return enough.error();
    }
    auto unpacked = containers::unpackChunk(compression, packed, size, where, goOn);
    if (!unpacked) return unpacked.error();
    bag.mayUnpack -= size;
    return ByteView(bag.unpacked.emplace_back(std::move(*unpacked)));
}

std::optional<ByteView> plainMessage(RosBag& bag, ByteView message, const std::string& where, const std::function<bool()>& goOn) {
    if (!containers::isZstd(message)) return message;
    const auto size = containers::zstdSize(message);
    const auto unpacked = size ? unpackedInto(bag, "zstd", message, *size, where, goOn) : Result<ByteView>(Error{"", where, ""});
    return unpacked ? std::optional(*unpacked) : std::nullopt;
}

std::optional<RosTopic> rosTopic(const std::string& name, std::string_view encoding, std::string_view type,
                                 std::string_view definitionEncoding, const std::string& definition) {
    const bool cdr = encoding == "cdr";
    if (!cdr && encoding != "ros1") return std::nullopt;
    RosTopic topic{name, rosTypeName(type), definition, cdr ? RosEncoding::Cdr : RosEncoding::Ros1, false};
    const bool known = definitionEncoding.empty() || definitionEncoding == (cdr ? "ros2msg" : "ros1msg");
    if (known && !definition.empty()) return topic;
    topic.definition = commonRosDefinition(topic.type);
    topic.assumed = true;
    return topic;
}

bool hasRosTopics(const containers::McapContent& content) {
    for (const auto& [id, channel] : content.channels) {
        if (topicOf(content, channel)) return true;
    }
    return false;
}

Result<RosBag> rosBagOf(const containers::McapContent& content, const std::string& where, const std::function<bool()>& goOn) {
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
    for (const containers::McapMessage& message : content.messages) packed += message.payload.size();
    bag.mayUnpack = mostUnpackedBytes(packed);
    constexpr std::size_t kBetweenLooks = 64; // at the wish to stop
    std::size_t bad = 0, looked = 0;
    for (const containers::McapMessage& message : content.messages) {
        const auto topic = topics.find(message.channel);
        if (topic == topics.end()) continue;
        if (goOn && looked++ % kBetweenLooks == 0 && !goOn()) return Error{"cancelled", where, ""};
        const auto bytes = plainMessage(bag, message.payload, where, goOn);
        if (bytes)
            bag.messages.push_back({topic->second, static_cast<std::int64_t>(message.logNs), *bytes});
        else
            ++bad;
    }
    if (bad > 0 && goOn && !goOn()) return Error{"cancelled", where, ""};
    bag.warnings = content.warnings;
    if (!content.clean && content.badChunks == 0 && content.warnings.empty())
        bag.warnings.emplace_back("The bag was cut off: everything up to the cut is here.");
    if (bad > 0)
        bag.warnings.push_back(
            counted(bad, "message is compressed and damaged and was left out.", "messages are compressed and damaged and were left out."));
    return bag;
}

} // namespace edgescan::robots
