// A robot has a laser at rest and one that tilts: its frame, what it sees and its names say which is which.
#include "core/robots/sweeps/turned_first.h"
#include "core/base/number_text.h"

#include "core/robots/sweeps/bag_place.h"
#include "core/robots/sweeps/laser_lines.h"
#include "core/robots/sweeps/laser_motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <set>
#include <tuple>
#include <utility>

namespace edgescan::robots {
namespace {

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

} // namespace

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

} // namespace edgescan::robots
