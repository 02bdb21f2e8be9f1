// Several lasers in one bag: which of them is turned.
#pragma once

#include "core/robots/sweeps/bag_topics.h"

#include <functional>
#include <string>
#include <vector>

namespace edgescan::robots {

/// Puts topics of lines into the order in which they may be sweeps: first those whose frame the transforms turn; then those that see
/// something else where the joint that turned furthest is at its other end (or `joint`, if it has a name); then those whose names share
/// most words with it. Topics of clouds go behind them. `goOn`: false ends the
/// work early, in any order.
void turnedFirst(const RosBag& bag, const std::string& joint, std::vector<BagTopic>& topics, const std::function<bool()>& goOn);

} // namespace edgescan::robots
