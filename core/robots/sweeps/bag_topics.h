// The topics of a bag, what each would give, and which one is taken.
#pragma once

#include "core/base/result.h"
#include "core/robots/bags/bag.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace edgescan::robots {

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

} // namespace edgescan::robots
