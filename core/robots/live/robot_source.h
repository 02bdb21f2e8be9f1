// A robot's bridge as the source of a live scan: its topics, the lines of its laser, or its whole clouds.
#pragma once

#include "core/base/result.h"
#include "core/files/live_feed/live_feed.h"
#include "core/robots/bridge/bridge_connection.h"

#include <string>
#include <vector>

namespace edgescan::robots {

/// Each message is a whole cloud.
[[nodiscard]] bool isCloud(const BridgeChannel& channel);

/// The laser `topic`, or without a name one whose name says that it is turned, else the first one by name, and the topics of transforms and
/// joints that give the angles of its lines; nothing else. Where there is no topic of lines, one of clouds, alone. Error: there is no
/// laser, or `topic` is not one; the hint lists those there are.
Result<BridgeChoice> chooseTopics(const std::vector<BridgeChannelPtr>& offered, const std::string& topic, const std::string& where);

/// As Addon::live.
std::unique_ptr<files::LiveSource> liveRobot(const scanner::ConnectionSettings& asked, const scanner::SweepSettings& sweep,
                                             std::function<void()> changed, std::mutex& mutex);

} // namespace edgescan::robots
