// Messages with the same topic and bytes: they hold their stamps.
#include "core/robots/sweeps/repeated_messages.h"
#include "core/base/translated_text.h"

#include "core/robots/sweeps/bag_topics.h"

#include <map>
#include <string_view>
#include <unordered_set>
#include <utility>

namespace edgescan::robots {

RosBag onceEach(RosBag bag) {
    std::vector<bool> looked;
    for (const RosTopic& topic : bag.topics) looked.push_back(givenBy(topic.type) != TopicGives::Nothing || givesAngles(topic.type));
    std::map<std::string, std::pair<std::unordered_set<std::string_view>, std::size_t>> topics; // by name: bytes, and how many repeat
    std::erase_if(bag.messages, [&](const RosBagMessage& message) {
        if (!looked[message.topic]) return false;
        auto& [known, repeated] = topics[bag.topics[message.topic].name];
        const bool again = !known.insert({reinterpret_cast<const char*>(message.bytes.data()), message.bytes.size()}).second;
        repeated += again ? 1 : 0;
        return again;
    });
    for (const auto& [name, messages] : topics) {
        if (messages.second > 0 && !name.ends_with("tf_static"))
            bag.warnings.push_back(
                withValues("%1 messages of the topic %2 are in the bag twice: each was read once.", {messages.second, name}));
    }
    return bag;
}

} // namespace edgescan::robots
