// Which topic of a bag is a scan.
#include "core/robots/sweeps/bag_topics.h"

#include "core/base/number_text.h"
#include "core/base/translated_text.h"
#include "core/robots/sweeps/frames.h"
#include "core/robots/sweeps/laser_lines.h"
#include "core/robots/sweeps/laser_motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <set>
#include <tuple>
#include <utility>

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

constexpr std::ptrdiff_t kMostLasers = 8;                // that are looked at
constexpr double kChangedM = 0.05, kChangedShare = 0.02; // of a range; of the beams

struct Fan {
    std::string frame;
    double middleDeg = 0;
    std::int64_t fromNs = 0, toNs = 0;
};

/// Calls `visit` with each readable line of a topic and its message.
template <class Visit>
void eachLine(const RosBag& bag, std::uint32_t topic, const Visit& visit) {
    const RosTopic& of = bag.topics[topic];
    const auto definition = rosDefinition(of.type, of.definition, "");
    for (const RosBagMessage& stored : bag.messages) {
        if (stored.topic != topic || !definition) continue;
        const auto message = rosMessage(*definition, of.encoding, stored.bytes, "");
        if (!message) continue;
        if (const auto line = laserLine(*message, scanner::Echo::First)) visit(*line, *message);
    }
}

std::optional<Fan> fanOf(const RosBag& bag, std::uint32_t topic) {
    std::optional<Fan> fan;
    eachLine(bag, topic, [&](const LaserLine& line, const RosValue& message) {
        if (!fan) fan = Fan{frameNameOf(message.text("header.frame_id")), middleOf(line), line.stampNs, line.stampNs};
        fan->fromNs = std::min(fan->fromNs, line.stampNs);
        fan->toNs = std::max(fan->toNs, line.stampNs);
    });
    return fan;
}

/// Whether the laser sees something else at the least angle of the joint than at the largest: one at rest sees the same in every line.
bool sawTheTurn(const RosBag& bag, std::uint32_t topic, const std::vector<TimedAngle>& angles, const Fan& fan) {
    std::vector<TimedAngle> within;
    std::ranges::copy_if(angles, std::back_inserter(within),
                         [&](const TimedAngle& at) { return at.ns >= fan.fromNs && at.ns <= fan.toNs; });
    if (within.empty()) return false;
    const auto [low, high] = std::ranges::minmax_element(within, {}, &TimedAngle::deg);
    struct Nearest {
        std::int64_t wantedNs, awayNs;
        std::vector<float> rangeMm;
    };
    std::array<Nearest, 2> ends{Nearest{low->ns, INT64_MAX, {}}, Nearest{high->ns, INT64_MAX, {}}};
    eachLine(bag, topic, [&](const LaserLine& line, const RosValue&) {
        for (Nearest& end : ends) {
            const std::int64_t away = std::abs(line.stampNs - end.wantedNs);
            if (away < end.awayNs) end = {end.wantedNs, away, line.line.ranges.rangeMm};
        }
    });
    const std::size_t beams = std::min(ends[0].rangeMm.size(), ends[1].rangeMm.size());
    std::size_t changed = 0;
    for (std::size_t j = 0; j < beams; ++j) changed += std::abs(ends[0].rangeMm[j] - ends[1].rangeMm[j]) > 1000 * kChangedM ? 1 : 0;
    return static_cast<double>(changed) > kChangedShare * static_cast<double>(beams);
}

/// "robot_1/laser_tilt_link" -> 1, laser, link, robot, tilt.
std::set<std::string> wordsOf(const std::string& names) {
    std::set<std::string> words;
    std::string word;
    for (const char c : asciiLower(names) + " ") {
        if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) {
            word += c;
        } else if (!word.empty()) {
            words.insert(std::exchange(word, {}));
        }
    }
    return words;
}

std::size_t shared(const std::set<std::string>& a, const std::set<std::string>& b) {
    return static_cast<std::size_t>(std::ranges::count_if(a, [&](const std::string& word) { return b.contains(word); }));
}

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

// A robot has a laser at rest and one that tilts: its frame, what it sees and its names say which is which.

void turnedFirst(const RosBag& bag, const std::string& joint, std::vector<BagTopic>& topics, const std::function<bool()>& goOn) {
    const auto clouds =
        std::stable_partition(topics.begin(), topics.end(), [](const BagTopic& topic) { return topic.gives == TopicGives::Lines; });
    if (clouds - topics.begin() < 2) return;
    const auto last = topics.begin() + std::min(clouds - topics.begin(), kMostLasers);
    auto tree = transformsIn(bag, "", goOn);
    if (tree) tree->finish();
    struct Chance {
        BagTopic topic;
        std::tuple<bool, bool, std::size_t> order; // turned by transforms; sees the joint turn; words shared with the joint
    };
    std::vector<Chance> chances;
    for (auto topic = topics.begin(); topic != last && goOn(); ++topic) {
        Chance chance{*topic, {}};
        if (const auto fan = fanOf(bag, topic->topic)) {
            std::get<0>(chance.order) =
                joint.empty() && tree && motionByFrames(*tree, fan->frame, fan->middleDeg, fan->fromNs, fan->toNs, "");
            if (const auto turns = motionByJoint(bag, joint, fan->fromNs, fan->toNs, "", goOn)) {
                std::get<1>(chance.order) = sawTheTurn(bag, topic->topic, turns->angles, *fan);
                std::get<2>(chance.order) = shared(wordsOf(bag.topics[topic->topic].name + ' ' + fan->frame), wordsOf(turns->mover));
            }
        }
        chances.push_back(std::move(chance));
    }
    std::ranges::stable_sort(chances, std::greater<>(), &Chance::order);
    std::ranges::transform(chances, topics.begin(), &Chance::topic);
}

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
