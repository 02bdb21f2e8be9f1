// What a group above this one adds where the build has it: more kinds of files, and more scanners. It registers itself in one file.
#pragma once

#include "core/base/result.h"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace edgescan {
struct ReadingOptions;
struct Scan;
} // namespace edgescan
namespace edgescan::containers {
struct McapContent;
} // namespace edgescan::containers
namespace edgescan::scanner {
struct ConnectionSettings;
struct PlayedLine;
struct SweepSettings;
} // namespace edgescan::scanner

namespace edgescan::files {

/// What a topic of a file or of a live source would give, for people who choose one.
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

struct Format;
class LiveSource;
struct PacketFile;
struct Reading;
class RecordedSource;
struct Source;

/// All functions are null where nothing is added.
struct Addon {
    std::vector<Format> (*formats)() = nullptr;
    /// Of an MCAP file that may be no recording of a scanner; empty: nothing in it is known.
    std::optional<Result<Reading>> (*readMcap)(const Source&) = nullptr;
    /// Of a capture without telegrams; empty: no packet of it is known.
    std::optional<Result<Scan>> (*readPackets)(const PacketFile&, const Source&) = nullptr;
    /// One scan of several files. Empty: it is one file, which replaces `path` where that is a folder.
    std::optional<Result<Scan>> (*openSeveral)(std::filesystem::path& path, const ReadingOptions&,
                                               const std::function<void(const scanner::PlayedLine&)>& played) = nullptr;
    /// A sentence that the file is one part of several, and which file opens them all; empty: it is not.
    std::string (*partOf)(const std::filesystem::path&) = nullptr;
    /// Of the options only `progress` counts. Empty: the file has no topics, or cannot be read at all.
    std::optional<Result<BagListing>> (*topicsOf)(const std::filesystem::path&, const ReadingOptions&) = nullptr;
    /// What plays a recording without telegrams; null: nothing in it is known. The content must outlive it.
    Result<std::unique_ptr<RecordedSource>> (*recorded)(const containers::McapContent&, const std::string& where,
                                                        const std::function<bool()>& goOn) = nullptr;
    /// `changed`: as that of a LiveFeed, whose lock is `mutex`.
    std::unique_ptr<LiveSource> (*live)(const scanner::ConnectionSettings&, const scanner::SweepSettings&, std::function<void()> changed,
                                        std::mutex& mutex) = nullptr;
};

[[nodiscard]] const Addon& addon();

/// A constant of this type in the file of the group registers it, before main() begins.
struct RegisteredAddon {
    explicit RegisteredAddon(const Addon& added);
};

/// Follows what was refused where nothing is added.
inline constexpr const char* kNoRobots = "this build has no robots: it reads no ROS bags, no VLP-16, no Ouster and no Foxglove bridge";
inline constexpr const char* kBuildWithRobots = "use a build with robots (EDGESCAN_ROBOTS)";

} // namespace edgescan::files
