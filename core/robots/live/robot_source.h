// A robot's bridge as the source of a live scan: its topics, the lines of its laser, or its whole clouds.
#pragma once

#include "core/files/live_feed/live_feed.h"

namespace edgescan::robots {

/// As Addon::live.
std::unique_ptr<files::LiveSource> liveRobot(const scanner::ConnectionSettings& asked, const scanner::SweepSettings& sweep,
                                             std::function<void()> changed, std::mutex& mutex);

} // namespace edgescan::robots
