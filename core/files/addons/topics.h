// What the topics of a file or of a live source would give, for people who choose one.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace edgescan::files {

struct ListedTopic {
    std::string name, type;
    std::size_t messages = 0;
    double hertz = 0;                  ///< mean rate; 0: fewer than two messages
    std::string frame;                 ///< of the first message; empty: it has none
    std::string gives;                 ///< "scan lines of 541 beams", "joints: tilt, wheel"; empty: nothing that is used
    bool isScan = false;               ///< --topic may choose it
    std::size_t size = 0;              ///< of a scan: beams of the first line, or points of the first cloud
    std::vector<std::string> joints{}; ///< names in the first message
};

struct BagListing {
    std::string kind; ///< "ROS 1 bag", "ROS 2 bag (MCAP)", "ROS 2 bag (SQLite)"
    std::vector<ListedTopic> topics;
    std::vector<std::string> warnings;
};

} // namespace edgescan::files
