// The messages of some topics of a bag, read in one pass: a bag may have as many topics as messages.
#pragma once

#include "core/robots/bags/bag.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace edgescan::robots {

/// Calls `visit` with topic and message for each message whose type `isWanted` accepts, in the order of the bag, and `damaged` for one that
/// cannot be read. `goOn`: false cancels; empty: never. Error: a definition is not understood, or cancelled.
template <class IsWanted, class Visit, class Damaged>
Result<Done> eachMessage(const RosBag& bag, const IsWanted& isWanted, const std::string& where, const Visit& visit, const Damaged& damaged,
                         const std::function<bool()>& goOn) {
    constexpr std::size_t kBetweenLooks = 16; // at the wish to stop
    std::vector<std::optional<RosDefinition>> definitions(bag.topics.size());
    for (std::size_t topic = 0; topic < bag.topics.size(); ++topic) {
        if (!isWanted(bag.topics[topic].type)) continue;
        auto definition = rosDefinition(bag.topics[topic].type, bag.topics[topic].definition, where);
        if (!definition) return definition.error();
        definitions[topic] = std::move(*definition);
    }
    std::size_t read = 0;
    for (const RosBagMessage& stored : bag.messages) {
        if (!definitions[stored.topic]) continue;
        if (goOn && read++ % kBetweenLooks == 0 && !goOn()) return Error{"cancelled", where, ""};
        const auto message = rosMessage(*definitions[stored.topic], bag.topics[stored.topic].encoding, stored.bytes, where);
        if (message)
            visit(stored.topic, *message);
        else
            damaged();
    }
    return Done{};
}

} // namespace edgescan::robots
