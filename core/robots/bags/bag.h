// ROS bags: messages with topic, time and definition, whatever container holds them.
#pragma once

#include "core/base/bytes.h"
#include "core/robots/bags/message.h"

#include <cstdint>
#include <functional>
#include <list>
#include <optional>
#include <string>
#include <vector>

namespace edgescan::containers {
struct McapContent;
} // namespace edgescan::containers

namespace edgescan::robots {

struct RosTopic {
    std::string name;       ///< "/scan"
    std::string type;       ///< "sensor_msgs/LaserScan"
    std::string definition; ///< text (definition.h)
    RosEncoding encoding = RosEncoding::Cdr;
    bool assumed = false; ///< the bag has no definition; the one of the ROS release of 2022 is used
};

struct RosBagMessage {
    std::uint32_t topic = 0; ///< index in RosBag::topics
    std::int64_t logNs = 0;  ///< when it was recorded, ns since 1970 UTC
    ByteView bytes;
};

/// Messages in the order of the file. They point into the bytes that were read, or into `unpacked`.
struct RosBag {
    std::string kind; ///< "ROS 1 bag", "ROS 2 bag (MCAP)", "ROS 2 bag (SQLite)"
    std::vector<RosTopic> topics;
    std::vector<RosBagMessage> messages;
    std::list<Bytes> unpacked;
    std::uint64_t mayUnpack = 0;       ///< bytes that compressed parts may still unpack to
    std::vector<std::string> warnings; ///< one sentence for each thing that was left out

    RosBag() = default;
    RosBag(RosBag&&) = default;
    RosBag& operator=(RosBag&&) = default;
    RosBag(const RosBag&) = delete; // the copy's messages would point into the original
    RosBag& operator=(const RosBag&) = delete;
};

/// The topic that a channel of MCAP or of a bridge describes. Empty: its messages are not those of ROS. A definition in another language is
/// replaced by the common one.
[[nodiscard]] std::optional<RosTopic> rosTopic(const std::string& name, std::string_view encoding, std::string_view type,
                                               std::string_view definitionEncoding, const std::string& definition);

[[nodiscard]] bool looksLikeRosBag(ByteView bytes);
[[nodiscard]] bool looksLikeSqlite(ByteView bytes);
/// Whether a recording of MCAP has topics of ROS.
[[nodiscard]] bool hasRosTopics(const containers::McapContent& content);

/// A bag of ROS 1, version 2.0 (wiki.ros.org/Bags/Format/2.0): chunks plain, bz2 or lz4; indexes are not used. `bytes` must outlive the
/// bag. What is torn or damaged costs only itself and gets a warning. `goOn` is called many times a second; false cancels. Error: another
/// version, or cancelled.
Result<RosBag> readRosBag(ByteView bytes, const std::string& where, const std::function<bool()>& goOn = {});

/// What SQLite left of a database that was not closed, as after a power cut: NAME-wal or NAME-journal.
struct DatabaseLog {
    std::string name; ///< of its file
    ByteView bytes;
};

/// A database of rosbag2: plain tables topics, messages and, since 2023, message_definitions; messages plain or zstd. What the logs hold is
/// read, too. `goOn` is called many times a second; false cancels. Error: no such database, tables that give more than the file can hold,
/// cancelled, or this program was built without SQLite.
Result<RosBag> readRosDatabase(ByteView bytes, const std::string& where, const std::vector<DatabaseLog>& logs = {},
                               const std::function<bool()>& goOn = {});

/// The ROS topics of a recording of MCAP; the content must outlive the bag. Error: `goOn` was called and gave false.
Result<RosBag> rosBagOf(const containers::McapContent& content, const std::string& where, const std::function<bool()>& goOn = {});

/// A compressed part of a bag, unpacked into the bag's own memory. Error: damaged, cancelled, or larger than a bag of its size may hold.
Result<ByteView> unpackedInto(RosBag& bag, const std::string& compression, ByteView packed, std::uint64_t size, const std::string& where,
                              const std::function<bool()>& goOn);
/// A message that rosbag2 compressed by itself, as its first bytes say, unpacked; any other message as it is. Empty: damaged, or cancelled.
std::optional<ByteView> plainMessage(RosBag& bag, ByteView message, const std::string& where, const std::function<bool()>& goOn);

/// The definition of a common type as the ROS release of 2022 has it, for bags without definitions; empty: the type is not common.
[[nodiscard]] std::string_view commonRosDefinition(std::string_view type);

} // namespace edgescan::robots
