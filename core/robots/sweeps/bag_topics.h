// The topics of a bag, what each would give, and which one is taken.
#pragma once

#include "core/base/result.h"
#include "core/files/addons/addon.h"
#include "core/robots/bags/bag.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace edgescan::robots {

using files::BagListing;
using files::ListedTopic;

enum class TopicGives : std::uint8_t { Nothing, Lines, Clouds };

[[nodiscard]] TopicGives givenBy(const std::string& type);
/// Transforms and joints.
[[nodiscard]] bool givesAngles(const std::string& type);

struct BagTopic {
    std::uint32_t topic = 0; ///< index in RosBag::topics
    TopicGives gives = TopicGives::Nothing;
    std::size_t messages = 0;
    double hertz = 0;        ///< mean rate; 0: fewer than two messages
    std::size_t largest = 0; ///< bytes of the largest message
};

/// One row per topic with messages, in the order of the bag.
[[nodiscard]] std::vector<BagTopic> bagTopics(const RosBag& bag);

/// "/scan (sensor_msgs/LaserScan, 1000 messages at 50 Hz)".
[[nodiscard]] std::string topicText(const RosBag& bag, const BagTopic& topic);

/// The topic called `name`. Without a name all that give scans: those of lines first, and of these that with most bytes. Error: the bag has
/// not this topic, or it has none that gives a scan; the hint lists those that do.
Result<std::vector<BagTopic>> topicsToTry(const RosBag& bag, const std::string& name, const std::string& where);

/// A sentence that this topic is a guess and which others give scans; empty: a name was given, or there is only this one.
[[nodiscard]] std::optional<std::string> guessText(const RosBag& bag, const BagTopic& taken, const std::string& name);

/// A row by the first message of a topic, without counts; of a topic without messages only what its type says.
[[nodiscard]] ListedTopic listedTopic(const RosTopic& topic, ByteView firstMessage);

/// One row per topic with messages, in the order of the bag.
[[nodiscard]] BagListing listingOf(const RosBag& bag);

/// Puts topics of lines into the order in which they may be sweeps: first those whose frame the transforms turn; then those that see
/// something else where the joint that turned furthest is at its other end (or `joint`, if it has a name); then those whose names share
/// most words with it. Topics of clouds go behind them. `goOn`: false ends the work early, in any order.
void turnedFirst(const RosBag& bag, const std::string& joint, std::vector<BagTopic>& topics, const std::function<bool()>& goOn);

} // namespace edgescan::robots
