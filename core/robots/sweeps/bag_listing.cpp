// Words for topics, from the first message of each.
#include "core/robots/sweeps/bag_listing.h"
#include "core/base/translated_text.h"

#include "core/robots/sweeps/bag_topics.h"
#include "core/robots/sweeps/frames.h"

#include <algorithm>

namespace edgescan::robots {
namespace {

constexpr std::size_t kMostNames = 20;

std::string textIn(const RosValue& value) { return {reinterpret_cast<const char*>(value.bytes.data()), value.bytes.size()}; }

std::string joined(const std::vector<std::string>& names) {
    std::string text;
    for (std::size_t n = 0; n < std::min(names.size(), kMostNames); ++n) text += (n == 0 ? "" : ", ") + names[n];
    return names.size() > kMostNames ? withValues("%1 and others", {text}) : text;
}

std::size_t lengthOf(const RosValue& message, const char* path) {
    const RosValue* array = message.at(path);
    return array == nullptr ? 0 : array->count;
}

std::string wholeText(const RosValue& message, const char* path) {
    return std::to_string(static_cast<long long>(message.number(path).value_or(0)));
}

std::vector<std::string> jointsIn(const RosValue& message) {
    std::vector<std::string> names;
    if (const RosValue* all = message.at("name")) {
        for (const RosValue& name : all->inside) names.push_back(textIn(name));
    }
    return names;
}

std::string linksIn(const RosValue& message) {
    std::vector<std::string> names;
    if (const RosValue* all = message.at("transforms")) {
        for (const RosValue& one : all->inside)
            names.push_back(frameNameOf(one.text("child_frame_id")) + " in " + frameNameOf(one.text("header.frame_id")));
    }
    return "transforms: " + joined(names);
}

std::string fieldsIn(const RosValue& message) {
    std::vector<std::string> names;
    if (const RosValue* all = message.at("fields")) {
        for (const RosValue& field : all->inside) names.emplace_back(field.text("name"));
    }
    return withValues("%1 x %2 points with %3", {wholeText(message, "height"), wholeText(message, "width"), joined(names)});
}

/// REP 145: a covariance of -1 means that there is no orientation.
std::string inertialIn(const RosValue& message) {
    const std::vector<double> covariance = message.numbers("orientation_covariance");
    const bool oriented = covariance.empty() || covariance.front() != -1;
    return withValues("%1turn rates and accelerations, which are not used: transforms and joints turn the laser",
                      {std::string(oriented ? "orientation, " : "")});
}

std::string given(const std::string& type, const RosValue& message) {
    if (type == "sensor_msgs/LaserScan" || type == "sensor_msgs/MultiEchoLaserScan")
        return withValues("scan lines of %1 beams", {lengthOf(message, "ranges")});
    if (type == "sensor_msgs/PointCloud2") return fieldsIn(message);
    if (type == "sensor_msgs/JointState") return "joints: " + joined(jointsIn(message));
    if (type == "tf2_msgs/TFMessage" || type == "tf/tfMessage") return linksIn(message);
    if (type == "geometry_msgs/PoseStamped") return withValues("poses in the frame %1", {frameNameOf(message.text("header.frame_id"))});
    if (type == "sensor_msgs/Imu") return inertialIn(message);
    return {};
}

} // namespace

ListedTopic listedTopic(const RosTopic& topic, ByteView firstMessage) {
    ListedTopic row{topic.name, topic.type, 0, 0, {}, {}, givenBy(topic.type) != TopicGives::Nothing};
    const auto definition = rosDefinition(topic.type, topic.definition, "");
    const auto message = definition ? rosMessage(*definition, topic.encoding, firstMessage, "") : Result<RosValue>(definition.error());
    if (!message) return row;
    row.frame = frameNameOf(message->text("header.frame_id"));
    row.gives = given(topic.type, *message);
    if (topic.type == "sensor_msgs/JointState") row.joints = jointsIn(*message);
    const auto whole = [&](const char* path) { return static_cast<std::size_t>(std::max(0.0, message->number(path).value_or(0))); };
    if (givenBy(topic.type) == TopicGives::Lines) row.size = lengthOf(*message, "ranges");
    if (givenBy(topic.type) == TopicGives::Clouds) row.size = whole("width") * whole("height");
    return row;
}

BagListing listingOf(const RosBag& bag) {
    BagListing listing{bag.kind, {}, bag.warnings};
    std::vector<const RosBagMessage*> first(bag.topics.size(), nullptr);
    for (const RosBagMessage& message : bag.messages) {
        if (first[message.topic] == nullptr) first[message.topic] = &message;
    }
    for (const BagTopic& topic : bagTopics(bag)) {
        ListedTopic row = listedTopic(bag.topics[topic.topic], first[topic.topic]->bytes);
        row.messages = topic.messages;
        row.hertz = topic.hertz;
        listing.topics.push_back(std::move(row));
    }
    return listing;
}

} // namespace edgescan::robots
