// Which topic of a bag is a scan.
#include "core/robots/sweeps/bag_topics.h"
#include "core/base/translated_text.h"

#include "core/base/number_text.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <utility>

namespace edgescan::robots {
namespace {

std::string listed(const RosBag& bag, const std::vector<BagTopic>& topics, bool scansOnly = true) {
    constexpr std::size_t kLongest = 1000;
    std::string text;
    for (const BagTopic& topic : topics) {
        if (scansOnly && topic.gives == TopicGives::Nothing) continue;
        if (text.size() > kLongest) return withValues("%1 and others", {text});
        text += (text.empty() ? "" : ", ") + topicText(bag, topic);
    }
    return text;
}

} // namespace

TopicGives givenBy(const std::string& type) {
    if (type == "sensor_msgs/LaserScan" || type == "sensor_msgs/MultiEchoLaserScan") return TopicGives::Lines;
    return type == "sensor_msgs/PointCloud2" ? TopicGives::Clouds : TopicGives::Nothing;
}

bool givesAngles(const std::string& type) {
    return type == "tf2_msgs/TFMessage" || type == "tf/tfMessage" || type == "sensor_msgs/JointState";
}

std::vector<BagTopic> bagTopics(const RosBag& bag) {
    struct Span {
        std::int64_t first = std::numeric_limits<std::int64_t>::max(), last = std::numeric_limits<std::int64_t>::min();
    };
    std::vector<BagTopic> all(bag.topics.size());
    std::vector<Span> spans(bag.topics.size());
    for (const RosBagMessage& message : bag.messages) {
        BagTopic& topic = all[message.topic];
        ++topic.messages;
        topic.largest = std::max(topic.largest, message.bytes.size());
        Span& span = spans[message.topic];
        span.first = std::min(span.first, message.logNs);
        span.last = std::max(span.last, message.logNs);
    }
    for (std::uint32_t n = 0; n < all.size(); ++n) {
        all[n].topic = n;
        all[n].gives = givenBy(bag.topics[n].type);
        if (all[n].messages > 1 && spans[n].last > spans[n].first)
            all[n].hertz = static_cast<double>(all[n].messages - 1) * 1e9 / static_cast<double>(spans[n].last - spans[n].first);
    }
    std::erase_if(all, [](const BagTopic& topic) { return topic.messages == 0; });
    return all;
}

std::string topicText(const RosBag& bag, const BagTopic& topic) {
    const RosTopic& of = bag.topics[topic.topic];
    return of.name + " (" + of.type + ", " + counted(topic.messages, "message") +
           (topic.hertz > 0 ? withValues(" at %1 Hz", {significantText(topic.hertz, 3)}) : "") + ")";
}

std::optional<std::string> guessText(const RosBag& bag, const BagTopic& taken, const std::string& name) {
    std::vector<BagTopic> others = bagTopics(bag);
    std::erase_if(others, [&](const BagTopic& topic) { return topic.topic == taken.topic; });
    const std::string scans = listed(bag, others);
    if (!name.empty() || scans.empty()) return std::nullopt;
    return withValues("GUESS: the topic %1 was taken; --topic chooses another: %2.", {topicText(bag, taken), scans});
}

Result<std::vector<BagTopic>> topicsToTry(const RosBag& bag, const std::string& name, const std::string& where) {
    const std::vector<BagTopic> topics = bagTopics(bag);
    const std::string scans = listed(bag, topics);
    const std::string leftOut = bag.warnings.empty() ? "" : "; " + bag.warnings.front().substr(0, bag.warnings.front().rfind('.'));
    if (scans.empty())
        return Error{withValues("no topic of this %1 is a laser's%2%3",
                                {bag.kind, topics.empty() ? "" : ": " + listed(bag, topics, false), leftOut}),
                     where, "choose another bag"};
    std::vector<BagTopic> found;
    for (const BagTopic& topic : topics) {
        const bool wanted = name.empty() ? topic.gives != TopicGives::Nothing : bag.topics[topic.topic].name == name;
        if (wanted) found.push_back(topic);
    }
    if (found.empty()) return Error{withValues("the bag has no topic \"%1\"", {name}), where, withValues("choose one of %1", {scans})};
    const auto rank = [](const BagTopic& topic) { return std::pair(topic.gives == TopicGives::Lines, topic.messages * topic.largest); };
    std::ranges::stable_sort(found, std::greater<>(), rank);
    std::erase_if(found, [](const BagTopic& topic) { return topic.gives == TopicGives::Nothing; });
    if (found.empty()) return Error{withValues("the topic %1 holds no scan", {name}), where, withValues("choose one of %1", {scans})};
    return found;
}

} // namespace edgescan::robots
