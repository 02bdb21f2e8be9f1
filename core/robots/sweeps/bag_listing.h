// What the topics of a bag would give, for people who choose one.
#pragma once

#include "core/files/addons/topics.h"
#include "core/robots/bags/bag.h"

namespace edgescan::robots {

using files::BagListing;
using files::ListedTopic;

/// A row by the first message of a topic, without counts; of a topic without messages only what its type says.
[[nodiscard]] ListedTopic listedTopic(const RosTopic& topic, ByteView firstMessage);

/// One row per topic with messages, in the order of the bag.
[[nodiscard]] BagListing listingOf(const RosBag& bag);

} // namespace edgescan::robots
